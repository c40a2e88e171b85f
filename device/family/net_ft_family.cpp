// SPDX-License-Identifier: GPL-3.0-or-later
// ATI Net F/T boxes and Ethernet Axia sensors.
#include "core/toml_reader.hpp"
#include "device/codec/net_ft_box_config.hpp"
#include "device/config/net_ft_sensor.hpp"
#include "device/emulator/emulated_net_ft.hpp"
#include "device/emulator/net_ft_server.hpp"
#include "device/family/buses.hpp"
#include "device/protocol/net_ft_log.hpp"
#include "device/protocol/net_ft_session.hpp"
#include "device/protocol/net_ft_setup.hpp"

namespace isograsp {

namespace {

SensorConfig standard_net_ft(std::size_t finger) {
  SensorConfig sensor;
  sensor.connection = NetFtSensor{"192.168.1." + std::to_string(1 + finger)};
  sensor.range << 145, 145, 290, 5, 5, 5;
  return sensor;
}

void read_net_ft_sensor(TomlReader& keys, SensorConfig& sensor) {
  auto& s = sensor.as<NetFtSensor>();
  s.host = keys.text("address", s.host);
  if (!NetFtAddress::parse(s.host))
    keys.fail("address", "not an address in numbers"_text, "write it as 192.168.1.1"_text);
}

std::string net_ft_udp_address(const SensorConfig& sensor) {
  const auto address = NetFtAddress::parse(sensor.as<NetFtSensor>().host);
  return address ? address->records.text() : "";
}

/// Every box tells on its web page what its counts mean.
Result<std::unique_ptr<SensorSession>> ask_net_ft_session(const DeviceConfig& config,
                                                          std::size_t finger) {
  constexpr Timestamp kPatience = std::chrono::seconds(2);
  auto box = set_up_net_ft_box(config, finger, kPatience);
  if (!box) return box.error();
  return std::unique_ptr<SensorSession>(
      std::make_unique<NetFtSession>(config, finger, *std::move(box)));
}

constexpr std::array kNetFtBuses{FamilyBus{"udp", open_udp_bus, "three ATI Net F/T boxes",
                                           "a network to the boxes, their web page reachable"}};

}  // namespace

constinit const FamilyFacts kNetFtFamily{
    .name = "net-ft",
    .title = "ATI Net F/T",
    .buses = kNetFtBuses,
    .standard = standard_net_ft,
    .read_sensor = read_net_ft_sensor,
    .identities =
        [](const SensorConfig& sensor) { return std::vector{sensor.as<NetFtSensor>().host}; },
    .place = [](const SensorConfig& sensor) { return "box " + sensor.as<NetFtSensor>().host; },
    .udp_address = net_ft_udp_address,
    .set_address = [](SensorConfig& sensor,
                      const std::string& address) { sensor.as<NetFtSensor>().host = address; },
    .make_session = [](const DeviceConfig& config,
                       std::size_t finger) -> std::unique_ptr<SensorSession> {
      return std::make_unique<NetFtSession>(config, finger, NetFtBoxConfig{});
    },
    .ask_session = ask_net_ft_session,
    .make_emulated = make_emulated_net_ft,
    .open_emulated = open_net_ft_boxes,
    .read_log = read_net_ft_log,
    .filter_remedy = "set it in the box's web page, leave filter_Hz out"_text};

}  // namespace isograsp
