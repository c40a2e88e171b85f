// SPDX-License-Identifier: GPL-3.0-or-later
// Signals files: what is accepted is a table on one rising time axis, and is written as it was
// read.
#include <cmath>

#include "core/csv.hpp"
#include "tests/fuzz/support.hpp"
#include "tests/support/temporary_folder.hpp"

using namespace isograsp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  static const test::TemporaryFolder folder;
  const auto text = fuzz::as_text(data, size);
  file.write(text);
  const auto signals = read_signals(file.path());
  if (!signals) {
    fuzz::require_helpful(signals.error(), text);
    return 0;
  }
  const auto t_s = signals->column("t_s");
  fuzz::require(t_s.size() == signals->rows() && t_s.size() >= 2, "there are two rows at least");
  for (std::size_t i = 1; i < t_s.size(); ++i) fuzz::require(t_s[i] > t_s[i - 1], "time increases");
  // A first column named "#…" can stand in a file only behind a blank.
  if (signals->names().front().starts_with('#')) return 0;

  const auto path = folder.path("written.csv");
  fuzz::require(write_signals(*signals, path).ok(), "signals can be written");
  const auto again = read_signals(path);
  fuzz::require(
      again.ok() && again->names() == signals->names() && again->rows() == signals->rows(),
      "what is written can be read");
  for (std::size_t c = 0; c < signals->names().size(); ++c)
    for (std::size_t r = 0; r < t_s.size(); ++r)
      fuzz::require(std::isnan(signals->column(c)[r])
                        ? std::isnan(again->column(c)[r])
                        : fuzz::same_bits(signals->column(c)[r], again->column(c)[r]),
                    "every value comes back to the last bit");
  return 0;
}
