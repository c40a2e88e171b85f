// SPDX-License-Identifier: GPL-3.0-or-later
// Raw CAN logs in the format of can-utils' candump -L: "(1700000000.001000) can0 064#0C00".
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/bus.hpp"

namespace isograsp {

struct CandumpEntry {
  std::string time_text;   ///< the log's own characters between the parentheses
  Timestamp wall_time{0};  ///< UTC since 1970
  std::string interface;
  BusFrame frame;
  bool flexible_data_rate = false;  ///< a CAN FD frame: `frame` carries its identifier only
};

/// Reads one line without its end. nullopt: a line that does not begin with "(" (DROPCOUNT and the
/// like stand in logs). Errors carry no file and no line.
[[nodiscard]] Result<std::optional<CandumpEntry>> parse_candump_line(std::string_view line);

/// One line without its end, six fraction digits.
[[nodiscard]] std::string format_candump_line(Timestamp wall_time, std::string_view interface,
                                              const BusFrame& frame);

/// Reads a log entry by entry, in constant memory.
class CandumpReader {
 public:
  [[nodiscard]] static Result<CandumpReader> open(const std::string& path);
  /// False at the end. Errors name file and line.
  [[nodiscard]] Result<bool> next(CandumpEntry& entry);

 private:
  std::string path_;
  std::ifstream in_;
  std::string text_;
  int line_ = 0;
};

}  // namespace isograsp
