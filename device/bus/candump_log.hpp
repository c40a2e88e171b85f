// SPDX-License-Identifier: GPL-3.0-or-later
// Raw CAN logs in the format of can-utils' candump -L: "(1700000000.001000) can0 064#0C00".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/bus.hpp"
#include "device/bus/log_line.hpp"

namespace isograsp {

struct CandumpEntry {
  std::string time_text;   ///< the log's own characters between the parentheses
  Timestamp wall_time{0};  ///< UTC since 1970
  std::string interface;
  BusFrame frame;
  bool flexible_data_rate = false;  ///< a CAN FD frame: `frame` carries its identifier only
};

/// Reads one line without its end. nullopt: a line that does not begin with "("; logs hold such
/// lines, e.g. DROPCOUNT. Errors carry no file and no line.
[[nodiscard]] Result<std::optional<CandumpEntry>> parse_candump_line(std::string_view line);

/// One line without its end, six fraction digits.
[[nodiscard]] std::string format_candump_line(Timestamp wall_time, std::string_view interface,
                                              const BusFrame& frame);

using CandumpReader = LogReader<CandumpEntry, parse_candump_line>;

}  // namespace isograsp
