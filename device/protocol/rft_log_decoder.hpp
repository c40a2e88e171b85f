// SPDX-License-Identifier: GPL-3.0-or-later
// Reads Robotous RFT sensors out of a log of a CAN bus; their scale is that of the configuration.
#pragma once

#include <memory>

#include "device/config/device_config.hpp"
#include "device/protocol/log_decoder.hpp"

namespace isograsp {

/// @pre the sensors are reached as RftSensor
[[nodiscard]] std::unique_ptr<LogDecoder> make_rft_log_decoder(const DeviceConfig& config);

}  // namespace isograsp
