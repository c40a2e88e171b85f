// SPDX-License-Identifier: GPL-3.0-or-later
// Any TOML: read or refused in a line of bounded length, whatever the file nests or repeats.
#include "core/toml_reader.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto text = fuzz::as_text(data, size);
  constexpr std::size_t kLongest = 1000;
  auto reader = TomlReader::parse(text, "x.toml", "isograsp-scene-1");
  if (!reader) {
    fuzz::require(reader.error().message().size() < kLongest, "an error is a line to read");
    return 0;
  }
  (void)reader->text("name", "");
  (void)reader->numbers("x", 0, 3, false);
  auto table = reader->table("t", false);
  (void)table.number("y", 0.0);
  for (auto& one : reader->tables("list")) (void)one.texts("words", false);
  const auto finished = reader->finish();
  fuzz::require(finished.ok() || finished.error().message().size() < kLongest,
                "an error is a line to read");
  return 0;
}
