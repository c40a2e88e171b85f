// SPDX-License-Identifier: GPL-3.0-or-later
// Device files: what is accepted describes three sensors that can be read.
#include "device/config/device_config.hpp"

#include <cmath>

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr double kRounding = 1e-9;
  const auto text = fuzz::as_text(data, size);
  const auto config = DeviceConfig::parse(text, "device.toml");
  if (!config) {
    fuzz::require(!config.error().what.empty() && !config.error().remedy.empty(),
                  "an error says what and what to do");
    if (config.error().file == "device.toml") fuzz::require_helpful(config.error(), text);
    return 0;
  }
  fuzz::require(std::isfinite(config->rate_Hz) && config->rate_Hz > 0.0, "a device has a rate");
  fuzz::require(std::isfinite(config->filter_Hz) && config->filter_Hz >= 0.0,
                "a filter has a frequency");
  const Wrench wrench{Vec3(1.0, -2.0, 3.0), Vec3(0.1, 0.2, -0.3)};
  for (const auto& sensor : config->sensors) {
    fuzz::require((sensor.range.array() > 0.0).all() && sensor.range.allFinite(),
                  "a sensor has a range");
    fuzz::require(std::abs(sensor.mounting.q_CS.norm() - 1.0) < kRounding,
                  "a mounting is a rotation");
    fuzz::require(std::abs(sensor.mounting.sign) == 1.0, "a sign is a sign");
    const Wrench there = sensor.mounting.to_contact(wrench);
    fuzz::require(std::abs(there.force.norm() - wrench.force.norm()) < kRounding,
                  "a mounting keeps the size of a force");
  }
  return 0;
}
