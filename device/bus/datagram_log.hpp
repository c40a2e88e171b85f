// SPDX-License-Identifier: GPL-3.0-or-later
// Raw logs of datagrams, one a line: "(1700000000.001000) 192.168.1.1:49152 0000000100…", with the
// address that it came from and its bytes in hexadecimal.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/endpoint.hpp"
#include "device/bus/log_line.hpp"

namespace isograsp {

struct DatagramEntry {
  std::string time_text;   ///< the log's own characters between the parentheses
  Timestamp wall_time{0};  ///< UTC since 1970
  Endpoint from;
  std::vector<std::uint8_t> bytes;
};

/// Reads one line without its end. nullopt: a line without any text. Errors carry no file and no
/// line.
[[nodiscard]] Result<std::optional<DatagramEntry>> parse_datagram_line(std::string_view line);

/// One line without its end, six fraction digits.
[[nodiscard]] std::string format_datagram_line(Timestamp wall_time, const Endpoint& from,
                                               std::span<const std::uint8_t> bytes);

using DatagramLogReader = LogReader<DatagramEntry, parse_datagram_line>;

}  // namespace isograsp
