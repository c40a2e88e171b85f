// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of CAN logs: what was read is written and read again as the same frame.
#include "device/bus/candump_log.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto line = fuzz::as_text(data, size);
  const auto parsed = parse_candump_line(line);
  if (!parsed) {
    fuzz::require_helpful(parsed.error(), line);
    return 0;
  }
  if (!parsed->has_value()) return 0;
  const CandumpEntry& entry = **parsed;
  fuzz::require(entry.wall_time.count() >= 0, "a log begins after 1970");
  if (entry.flexible_data_rate) return 0;
  fuzz::require(entry.frame.length <= 8, "a classic frame has at most 8 bytes");
  const auto again =
      parse_candump_line(format_candump_line(entry.wall_time, entry.interface, entry.frame));
  fuzz::require(again.ok() && again->has_value(), "what is written can be read");
  fuzz::require((*again)->frame == entry.frame && (*again)->interface == entry.interface,
                "what is written is what was read");
  fuzz::require(entry.wall_time - (*again)->wall_time < std::chrono::microseconds(1),
                "time is kept to the microsecond");
  return 0;
}
