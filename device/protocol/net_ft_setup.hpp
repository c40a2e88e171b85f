// SPDX-License-Identifier: GPL-3.0-or-later
// What has to be agreed with a Net F/T box over its web pages before its records mean anything.
#pragma once

#include <cstddef>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/codec/net_ft_box_config.hpp"
#include "device/config/device_config.hpp"

namespace isograsp {

/// Asks the finger's box for its scale, serial number and rate, in at most `limit`; sets its rate
/// if it has another one. Refuses a wrong serial number, a rate that the box cannot have, and a box
/// that turns or shifts its wrenches. Errors name the finger and the page. Not real-time safe.
/// @pre config.sensors[finger] is reached as a NetFtSensor
[[nodiscard]] Result<NetFtBoxConfig> set_up_net_ft_box(const DeviceConfig& config,
                                                       std::size_t finger, Timestamp limit);

}  // namespace isograsp
