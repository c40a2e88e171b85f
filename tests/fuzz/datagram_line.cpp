// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of datagram logs: what was read is written and read again as the same datagram.
#include "device/bus/datagram_log.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto line = fuzz::as_text(data, size);
  const auto parsed = parse_datagram_line(line);
  if (!parsed) {
    fuzz::require_helpful(parsed.error(), line);
    return 0;
  }
  if (!parsed->has_value()) return 0;
  const DatagramEntry& entry = **parsed;
  fuzz::require(entry.wall_time.count() >= 0, "a log begins after 1970");
  fuzz::require(!entry.bytes.empty() && entry.from.port != 0, "a datagram has bytes and a sender");
  const auto again =
      parse_datagram_line(format_datagram_line(entry.wall_time, entry.from, entry.bytes));
  fuzz::require(again.ok() && again->has_value(), "what is written can be read");
  fuzz::require((*again)->from == entry.from && (*again)->bytes == entry.bytes,
                "what is written is what was read");
  fuzz::require(entry.wall_time - (*again)->wall_time < std::chrono::microseconds(1),
                "time is kept to the microsecond");
  return 0;
}
