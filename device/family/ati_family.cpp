// SPDX-License-Identifier: GPL-3.0-or-later
// ATI sensors with NETCANOEM boards.
#include <cstdio>

#include "device/config/ati_sensor.hpp"
#include "device/config/read_keys.hpp"
#include "device/emulator/emulated_ati.hpp"
#include "device/family/buses.hpp"
#include "device/protocol/ati_decoder.hpp"
#include "device/protocol/ati_session.hpp"
#include "device/protocol/learning_log_decoder.hpp"

namespace isograsp {

namespace {

SensorConfig standard_ati(std::size_t finger) {
  SensorConfig sensor;
  sensor.connection = AtiSensor{static_cast<std::uint8_t>(0x20 + finger), 0};
  sensor.range << 145, 145, 290, 5, 5, 5;
  return sensor;
}

void read_ati_sensor(TomlReader& keys, SensorConfig& sensor) {
  auto& s = sensor.as<AtiSensor>();
  s.base = read_id(keys, "base_id", s.base, 1, 0x7F);
  s.calibration = read_id(keys, "calibration_slot", s.calibration, 0, 15);
}

std::string ati_place(const SensorConfig& sensor) {
  const auto& s = sensor.as<AtiSensor>();
  char text[64];
  std::snprintf(text, sizeof text, "base 0x%02X, identifiers from 0x%03X, calibration %u",
                static_cast<unsigned>(s.base), static_cast<unsigned>(s.base) << 4,
                static_cast<unsigned>(s.calibration));
  return text;
}

/// Question and answer have the same identifier.
void add_ati_ids(const SensorConfig& sensor, CanIds& ids) {
  for (std::uint32_t op = 0; op < 16; ++op) {
    const std::uint32_t id = sensor.as<AtiSensor>().base * 16U + op;
    ids.sent.push_back(id);
    ids.heard.push_back(id);
  }
}

std::unique_ptr<LogDecoder> make_ati_log_decoder(const DeviceConfig& config) {
  std::vector<AtiDecoder> sensors;
  for (const auto& sensor : config.sensors) sensors.emplace_back(sensor.as<AtiSensor>().base);
  return std::make_unique<LearningLogDecoder<AtiDecoder>>(std::move(sensors));
}

constexpr std::array kAtiBuses{FamilyBus{
    "can", open_can_bus, "three ATI sensors with CAN boards",
    "a CAN adapter with a Linux driver, 250 kbit/s or as the boards are set, switched on"}};

}  // namespace

constinit const FamilyFacts kAtiFamily{
    .name = "ati-netcanoem",
    .title = "ATI NETCANOEM",
    .buses = kAtiBuses,
    .standard = standard_ati,
    .read_sensor = read_ati_sensor,
    .identities =
        [](const SensorConfig& sensor) {
          return std::vector{std::to_string(sensor.as<AtiSensor>().base)};
        },
    .place = ati_place,
    .add_can_ids = add_ati_ids,
    .make_session = [](const DeviceConfig& config, std::size_t finger)
        -> std::unique_ptr<SensorSession> { return std::make_unique<AtiSession>(config, finger); },
    .make_emulated = make_emulated_ati,
    .make_log_decoder = make_ati_log_decoder,
    .filter_remedy = "this board has none: leave filter_Hz out and use fir_taps"_text};

}  // namespace isograsp
