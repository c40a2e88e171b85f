// SPDX-License-Identifier: GPL-3.0-or-later
// A Robotous RFT sensor in software: idle at power-up, deaf to all but stop and bias while it
// streams, identifiers that act after the next power-up.
#pragma once

#include <cstddef>
#include <memory>

#include "device/config/device_config.hpp"
#include "device/emulator/emulated_sensor.hpp"

namespace isograsp {

/// @pre config.sensors[finger] is reached as a RftSensor
[[nodiscard]] std::unique_ptr<EmulatedSensor> make_emulated_rft(std::size_t finger,
                                                                const DeviceConfig& config);

}  // namespace isograsp
