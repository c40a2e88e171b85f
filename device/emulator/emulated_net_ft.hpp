// SPDX-License-Identifier: GPL-3.0-or-later
// A Net F/T box in software: idle at power-up, measures 7000 times a second inside and sends every
// n-th measurement with both numbers. Faults of the network are played by the emulator around it.
#pragma once

#include <cstddef>
#include <memory>

#include "device/config/device_config.hpp"
#include "device/emulator/emulated_sensor.hpp"

namespace isograsp {

/// @pre config.sensors[finger] is reached as a NetFtSensor
[[nodiscard]] std::unique_ptr<EmulatedSensor> make_emulated_net_ft(std::size_t finger,
                                                                   const DeviceConfig& config);

}  // namespace isograsp
