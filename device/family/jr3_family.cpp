// SPDX-License-Identifier: GPL-3.0-or-later
// JR3 sensors behind open CAN adaptors.
#include "device/config/jr3_sensor.hpp"
#include "device/config/read_keys.hpp"
#include "device/emulator/emulated_jr3.hpp"
#include "device/family/buses.hpp"
#include "device/protocol/jr3_decoder.hpp"
#include "device/protocol/jr3_session.hpp"
#include "device/protocol/learning_log_decoder.hpp"

namespace isograsp {

namespace {

SensorConfig standard_jr3(std::size_t finger) {
  SensorConfig sensor;
  sensor.connection = Jr3Sensor{static_cast<std::uint8_t>(1 + finger)};
  sensor.range << 150, 150, 300, 8, 8, 8;
  return sensor;
}

void read_jr3_sensor(TomlReader& keys, SensorConfig& sensor) {
  auto& s = sensor.as<Jr3Sensor>();
  s.node = read_id(keys, "node", s.node, 1, 127);
  if (!keys.text("serial_number", "").empty())
    keys.fail("serial_number",
              "this adaptor tells no serial number: nothing could be compared"_text,
              "leave it out; the guided check finds exchanged sensors"_text);
}

std::string jr3_node(const SensorConfig& sensor) {
  return std::to_string(sensor.as<Jr3Sensor>().node);
}

void add_jr3_ids(const SensorConfig& sensor, CanIds& ids) {
  constexpr std::uint32_t kSync = 0x080;
  const std::uint32_t node = sensor.as<Jr3Sensor>().node;
  for (const std::uint32_t op : {0x100U, 0x600U, 0x680U, 0x700U}) ids.sent.push_back(op + node);
  if (ids.heard.empty()) ids.heard.push_back(kSync);
  for (std::uint32_t op = 0x180; op <= 0x580; op += 0x80) ids.heard.push_back(op + node);
}

std::unique_ptr<LogDecoder> make_jr3_log_decoder(const DeviceConfig& config) {
  std::vector<Jr3Decoder> sensors;
  for (const auto& sensor : config.sensors) sensors.emplace_back(sensor.as<Jr3Sensor>().node);
  return std::make_unique<LearningLogDecoder<Jr3Decoder>>(std::move(sensors));
}

constexpr std::array kJr3Buses{
    FamilyBus{"can", open_can_bus, "three JR3 sensors with open CAN adaptors",
              "a CAN adapter with a Linux driver, 1 Mbit/s, switched on"}};

}  // namespace

constinit const FamilyFacts kJr3Family{
    .name = "jr3-can",
    .title = "JR3 with CAN adaptor",
    .buses = kJr3Buses,
    .filter_Hz = 31.25,  // the paper's
    .standard = standard_jr3,
    .read_sensor = read_jr3_sensor,
    .identities = [](const SensorConfig& sensor) { return std::vector{jr3_node(sensor)}; },
    .place = [](const SensorConfig& sensor) { return "node " + jr3_node(sensor); },
    .has_filter =
        [](double filter_Hz) {
          constexpr double kLargest_Hz = 655.35;  // 16 bits of 0.01 Hz
          return filter_Hz >= 0.0 && filter_Hz <= kLargest_Hz;
        },
    .add_can_ids = add_jr3_ids,
    .make_session = [](const DeviceConfig& config, std::size_t finger)
        -> std::unique_ptr<SensorSession> { return std::make_unique<Jr3Session>(config, finger); },
    .make_emulated = make_emulated_jr3,
    .make_log_decoder = make_jr3_log_decoder,
    .filter_remedy = "use 0 (none) to 655.35"_text};

}  // namespace isograsp
