// SPDX-License-Identifier: GPL-3.0-or-later
// The whole driver and three emulated sensors on a bus made of memory, in virtual time.
#pragma once

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "device/config/fir.hpp"
#include "device/config/rft_sensor.hpp"
#include "device/sensors/sensor_device.hpp"
#include "tests/device/counting_play.hpp"
#include "tests/device/emulated_bus.hpp"

namespace isograsp::test {

struct SensorBench {
  /// The driver believes `config`; the emulator has its own in `options`, of the same protocol,
  /// rate and filter.
  explicit SensorBench(EmulatorOptions options = {},
                       const DeviceConfig& config = DeviceConfig::standard(kRftFamily),
                       FingerPlay play = counting_play(3000)) {
    options.config.rate_Hz = config.rate_Hz;
    auto owned = std::make_unique<EmulatedBus>(std::move(options), std::move(play));
    bus = owned.get();
    std::vector<double> fir;
    if (config.fir_taps != 0)
      fir = design_fir(config.fir_taps, config.rate_Hz, config.fir_cutoff_Hz).value();
    device = std::make_unique<SensorDevice>(std::move(owned), make_sessions(config), config, fir,
                                            "can://test", "test");
  }
  /// Reads for a while; returns the samples.
  std::vector<SensorSample> read_for(Timestamp duration) {
    std::vector<SensorSample> samples;
    const Timestamp end = clock.now() + duration;
    SensorSample sample;
    while (device->read(end, sample) == ReadStatus::sample) samples.push_back(sample);
    return samples;
  }

  ManualClock clock;
  EmulatedBus* bus = nullptr;
  std::unique_ptr<SensorDevice> device;
};

}  // namespace isograsp::test
