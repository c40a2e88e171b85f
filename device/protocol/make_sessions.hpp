// SPDX-License-Identifier: GPL-3.0-or-later
// The conversations with three sensors, as their family has them.
#pragma once

#include <array>
#include <memory>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/sensor_session.hpp"

namespace isograsp {

using SensorSessions = std::array<std::unique_ptr<SensorSession>, kFingerCount>;

/// @pre rate and filter of the configuration exist
[[nodiscard]] SensorSessions make_sessions(const DeviceConfig& config);
/// The same, after asking the sensors for what their frames do not contain: the scale of their
/// counts. Errors name the finger. Not real-time safe: it may wait seconds for each sensor.
[[nodiscard]] Result<SensorSessions> ask_sessions(const DeviceConfig& config);

}  // namespace isograsp
