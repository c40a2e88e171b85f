// SPDX-License-Identifier: GPL-3.0-or-later
// All samples of a log of datagrams of Net F/T boxes.
#pragma once

#include <string>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/log_decoder.hpp"

namespace isograsp {

/// In the order of the log. Without `addresses_known` the senders are thumb, index and middle in
/// ascending order. Errors name file and line; a log without any frame is one.
/// @pre the sensors are reached as NetFtSensor
[[nodiscard]] Result<LogReport> read_net_ft_log(const std::string& path, const DeviceConfig& config,
                                                bool addresses_known, const TakeSample& take);

}  // namespace isograsp
