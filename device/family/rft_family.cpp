// SPDX-License-Identifier: GPL-3.0-or-later
// Robotous RFT sensors: on CAN, behind Ethernet converters, on serial lines.
#include <algorithm>
#include <cstdio>

#include "device/config/read_keys.hpp"
#include "device/config/rft_sensor.hpp"
#include "device/emulator/emulated_rft.hpp"
#include "device/family/buses.hpp"
#include "device/protocol/rft_log_decoder.hpp"
#include "device/protocol/rft_session.hpp"

namespace isograsp {

namespace {

SensorConfig standard_rft(std::size_t finger) {
  SensorConfig sensor;
  sensor.connection = RftSensor{kRftIds[finger], "", {}};
  return sensor;
}

void read_rft_sensor(TomlReader& keys, SensorConfig& sensor) {
  auto& s = sensor.as<RftSensor>();
  constexpr std::int64_t kLargest = 255;
  s.ids.command = read_id(keys, "command_id", s.ids.command, 1, kLargest);
  s.ids.first = read_id(keys, "first_id", s.ids.first, 1, kLargest);
  s.ids.second = read_id(keys, "second_id", s.ids.second, 1, kLargest);
  if (s.ids.first >= s.ids.second)
    keys.fail("second_id", "not above first_id: the bus could turn a pair of frames around"_text,
              "program the sensor so that first_id is the smaller one"_text);
  s.divisors.force_per_N = read_positive(keys, "force_divisor", s.divisors.force_per_N);
  s.divisors.torque_per_Nm = read_positive(keys, "torque_divisor", s.divisors.torque_per_Nm);
  s.address = keys.text("address", "");
}

void read_rft_device(TomlReader& root, DeviceConfig& config) {
  const auto table = root.choice("filter_codes", {"manual", "header"}, 0) == 0
                         ? RftFilterTable::manual
                         : RftFilterTable::header;
  constexpr std::array<std::int64_t, 5> kBauds{57600, 115200, 230400, 460800, 921600};
  const auto baud = root.integer("baud", RftSensor{}.baud);
  const bool exists = std::find(kBauds.begin(), kBauds.end(), baud) != kBauds.end();
  if (!exists)
    root.fail("baud", "the sensors have no such speed"_text,
              "use 57600, 115200, 230400, 460800 or 921600"_text);
  for (auto& sensor : config.sensors) {
    auto& s = sensor.as<RftSensor>();
    s.filter_table = table;
    if (exists) s.baud = static_cast<unsigned>(baud);
  }
}

std::vector<std::string> rft_identities(const SensorConfig& sensor) {
  const auto& s = sensor.as<RftSensor>();
  std::vector<std::string> all{std::to_string(s.ids.command), std::to_string(s.ids.first),
                               std::to_string(s.ids.second)};
  if (!s.address.empty()) all.push_back(s.address);
  return all;
}

std::string rft_place(const SensorConfig& sensor) {
  const auto& s = sensor.as<RftSensor>();
  if (!s.address.empty()) return s.address;
  char text[64];
  std::snprintf(text, sizeof text, "command 0x%02X, data 0x%02X and 0x%02X",
                static_cast<unsigned>(s.ids.command), static_cast<unsigned>(s.ids.first),
                static_cast<unsigned>(s.ids.second));
  return text;
}

void add_rft_ids(const SensorConfig& sensor, CanIds& ids) {
  const auto& s = sensor.as<RftSensor>();
  ids.sent.push_back(s.ids.first);
  ids.sent.push_back(s.ids.second);
  ids.heard.push_back(s.ids.command);
}

std::string rft_udp_address(const SensorConfig& sensor) {
  constexpr const char* kPort = ":311";
  const auto& address = sensor.as<RftSensor>().address;
  if (address.empty()) return "";
  return address + (address.find(':') == std::string::npos ? kPort : "");
}

Result<std::unique_ptr<Bus>> open_rft_lines(const Uri& uri, const DeviceConfig& config) {
  std::array<std::string, kFingerCount> ports;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    ports[f] = config.sensors[f].as<RftSensor>().address;
  if (auto known = check_addresses(uri, ports); !known) return known.error();
  return open_serial(ports, config.sensors[0].as<RftSensor>().baud);
}

std::unique_ptr<SensorSession> make_rft_session(const DeviceConfig& config, std::size_t finger) {
  const SensorConfig& sensor = config.sensors[finger];
  const auto& rft = sensor.as<RftSensor>();
  RftSession::Settings settings;
  if (rft.address.empty())
    settings.on_bus = rft.ids;
  else
    settings.on_bus = RftPeer{static_cast<std::uint32_t>(finger)};
  settings.address = rft.address;
  settings.serial_number = sensor.serial_number;
  settings.divisors = rft.divisors;
  settings.rate_Hz = config.rate_Hz;
  settings.filter_Hz = config.filter_Hz;
  settings.filter_table = rft.filter_table;
  return std::make_unique<RftSession>(settings);
}

constexpr std::array kRftBuses{
    FamilyBus{"can", open_can_bus, "three Robotous RFT sensors on one CAN bus",
              "a CAN adapter with a Linux driver, 1 Mbit/s, switched on"},
    FamilyBus{"udp", open_udp_bus, "", ""},
    FamilyBus{"serial", open_rft_lines, "three Robotous RFT sensors on serial lines",
              "the right to open the ports (group dialout)"}};

}  // namespace

constinit const FamilyFacts kRftFamily{
    .name = "rft",
    .title = "Robotous RFT",
    .buses = kRftBuses,
    .filter_Hz = 30.0,
    .standard = standard_rft,
    .read_device = read_rft_device,
    .read_sensor = read_rft_sensor,
    .identities = rft_identities,
    .place = rft_place,
    .has_rate = [](double rate_Hz) { return rft_rate_code(rate_Hz).has_value(); },
    .has_filter = [](double filter_Hz) { return rft_filter_code(filter_Hz).has_value(); },
    .add_can_ids = add_rft_ids,
    .udp_address = rft_udp_address,
    .set_address = [](SensorConfig& sensor,
                      const std::string& address) { sensor.as<RftSensor>().address = address; },
    .make_session = make_rft_session,
    .make_emulated = make_emulated_rft,
    .make_log_decoder = make_rft_log_decoder,
    .rate_remedy = "use 10, 20, 50, 100, 200, 333, 500 or 1000"_text,
    .filter_remedy =
        "use 0 (none), 500, 300, 200, 150, 100, 50, 40, 30, 20, 10, 5, 3, 2 or 1"_text};

}  // namespace isograsp
