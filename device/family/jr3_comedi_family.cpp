// SPDX-License-Identifier: GPL-3.0-or-later
// JR3 sensors on a PCI card in this computer. There is no wire, so there are no raw frames to log
// and no emulated sensors.
#include "device/codec/jr3_comedi_codec.hpp"
#include "device/comedi/comedi_bus.hpp"
#include "device/config/device_config.hpp"
#include "device/config/family_facts.hpp"
#include "device/config/jr3_comedi_sensor.hpp"
#include "device/config/read_keys.hpp"
#include "device/config/uri.hpp"
#include "device/protocol/jr3_comedi_session.hpp"

namespace isograsp {

namespace {

SensorConfig standard_jr3_comedi(std::size_t finger) {
  SensorConfig sensor;
  sensor.connection = Jr3ComediSensor{static_cast<unsigned>(finger)};
  sensor.range << 150, 150, 300, 8, 8, 8;
  return sensor;
}

void read_jr3_comedi_sensor(TomlReader& keys, SensorConfig& sensor) {
  auto& s = sensor.as<Jr3ComediSensor>();
  s.subdevice = read_id(keys, "subdevice", s.subdevice, 0, 3);
}

std::string jr3_subdevice(const SensorConfig& sensor) {
  return std::to_string(sensor.as<Jr3ComediSensor>().subdevice);
}

Result<std::unique_ptr<Bus>> open_jr3_card(const Uri& uri, const DeviceConfig& config) {
  std::array<unsigned, kFingerCount> subdevices{};
  for (std::size_t f = 0; f < kFingerCount; ++f)
    subdevices[f] = config.sensors[f].as<Jr3ComediSensor>().subdevice;
  return open_comedi_bus(uri.target, subdevices);
}

constexpr std::array kJr3ComediBuses{FamilyBus{"comedi", open_jr3_card, "", ""}};

}  // namespace

constinit const FamilyFacts kJr3ComediFamily{
    .name = "jr3-comedi",
    .title = "JR3 PCI",
    .buses = kJr3ComediBuses,
    .filter_Hz = 31.25,  // the paper's
    .standard = standard_jr3_comedi,
    .read_sensor = read_jr3_comedi_sensor,
    .identities = [](const SensorConfig& sensor) { return std::vector{jr3_subdevice(sensor)}; },
    .place = [](const SensorConfig& sensor) { return "subdevice " + jr3_subdevice(sensor); },
    .has_filter = [](double filter_Hz) { return jr3_comedi_filter(filter_Hz).has_value(); },
    .make_session = [](const DeviceConfig& config,
                       std::size_t finger) -> std::unique_ptr<SensorSession> {
      return std::make_unique<Jr3ComediSession>(config, finger);
    },
    .filter_remedy = "use 0 (none), 500, 125, 31.25, 7.8125, 1.953125 or 0.48828125"_text};

}  // namespace isograsp
