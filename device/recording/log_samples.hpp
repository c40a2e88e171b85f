// SPDX-License-Identifier: GPL-3.0-or-later
// All samples of a raw log: a candump log of a CAN bus, or a log of datagrams of Net F/T boxes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/config/device_config.hpp"
#include "device/protocol/log_decoder.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What a log held, by sensor and besides.
struct LogReport {
  std::array<DecodedCounts, kFingerCount> sensors{};
  std::uint64_t commands = 0;  ///< that are meant for all sensors
  std::uint64_t foreign = 0;   ///< frames that none of the sensors sends or hears
};

/// `time_text`: the log's own characters of the frame that completed the sample.
using TakeSample = std::function<void(const std::string& time_text, Timestamp wall_time,
                                      const DecodedSample& sample)>;

/// Hands every sample over in the order of the log, in constant memory; reads the log twice where
/// it tells its own scales. Without `addresses_known` the senders of datagrams are thumb, index and
/// middle in ascending order. Errors name file and line; a log without any frame is one.
[[nodiscard]] Result<LogReport> read_log(const std::string& path, const DeviceConfig& config,
                                         bool addresses_known, const TakeSample& take);

}  // namespace isograsp
