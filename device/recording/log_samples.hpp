// SPDX-License-Identifier: GPL-3.0-or-later
// All samples of a raw log: a candump log of a CAN bus, or a log of datagrams of Net F/T boxes.
#pragma once

#include <string>

#include "core/result.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/log_decoder.hpp"

namespace isograsp {

/// Hands every sample over in the order of the log, in constant memory; reads the log twice where
/// it tells its own scales. Without `addresses_known` the senders of datagrams are thumb, index and
/// middle in ascending order. Errors name file and line; a log without any frame is one.
[[nodiscard]] Result<LogReport> read_log(const std::string& path, const DeviceConfig& config,
                                         bool addresses_known, const TakeSample& take);

}  // namespace isograsp
