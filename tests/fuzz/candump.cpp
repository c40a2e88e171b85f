// SPDX-License-Identifier: GPL-3.0-or-later
// Whole CAN logs: the reader gives the frames of the lines, up to the first damaged one.
#include "device/bus/candump_log.hpp"
#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  auto text = fuzz::as_text(data, size);
  file.write(text);
  auto log = CandumpReader::open(file.path());
  fuzz::require(log.ok(), "a file that exists is opened");
  CandumpEntry entry;
  for (int line = 1; !text.empty(); ++line) {
    const auto end = text.find('\n');
    const auto expected = parse_candump_line(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (expected.ok() && !expected->has_value()) continue;
    const auto more = log->next(entry);
    fuzz::require(more.ok() == expected.ok(), "the reader refuses the lines that cannot be parsed");
    if (!more) {
      fuzz::require(more.error().line == line, "an error names its line");
      return 0;
    }
    fuzz::require(*more && entry.frame == (*expected)->frame, "no line is left out");
  }
  const auto more = log->next(entry);
  fuzz::require(more.ok() && !*more, "behind the last line there is nothing");
  return 0;
}
