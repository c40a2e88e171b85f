// SPDX-License-Identifier: GPL-3.0-or-later
// Finger-forces files: rising time, finite or absent samples, the same after writing and reading.
#include "hand/finger_forces.hpp"

#include "tests/fuzz/support.hpp"

using namespace isograsp;

namespace {

bool finite(const Wrench& wrench) {
  return wrench.force.allFinite() && wrench.torque.allFinite();
}

std::vector<FingerForcesRow> read(FingerForcesReader& reader, std::string_view text, bool& whole) {
  std::vector<FingerForcesRow> rows;
  FingerForcesRow row;
  for (;;) {
    const auto more = reader.next(row);
    whole = more.ok();
    if (!more) fuzz::require_helpful(more.error(), text);
    if (!more || !*more) return rows;
    rows.push_back(row);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::MemoryFile file;
  const auto text = fuzz::as_text(data, size);
  file.write(text);
  auto reader = FingerForcesReader::open(file.path());
  if (!reader) {
    fuzz::require_helpful(reader.error(), text);
    return 0;
  }
  bool whole = false;
  const auto rows = read(*reader, text, whole);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    fuzz::require(r == 0 || rows[r].t_s > rows[r - 1].t_s, "time increases");
    for (const Finger finger : kFingers) {
      const Wrench& wrench = rows[r].wrench_C[index_of(finger)];
      fuzz::require(finite(wrench), "a file of finite numbers gives finite wrenches");
      fuzz::require(rows[r].present[index_of(finger)] ||
                        (wrench.force.isZero(0.0) && wrench.torque.isZero(0.0)),
                    "an absent sample is zero");
    }
  }
  const auto grid = read_time_grid(file.path());
  fuzz::require(!whole || grid.ok() == (rows.size() >= 2), "a readable file has a time grid");
  if (whole && grid)
    fuzz::require(fuzz::same_bits(grid->hold_s, rows[1].t_s - rows[0].t_s),
                  "the first step is the hold");

  std::string written;
  for (const auto& name : finger_forces_columns()) written += (written.empty() ? "" : ",") + name;
  written += '\n';
  for (const auto& row : rows) append_finger_forces(written, row);
  file.write(written);
  auto second = FingerForcesReader::open(file.path());
  const auto again = read(*second, written, whole);
  fuzz::require(whole && again.size() == rows.size(), "what is written can be read");
  for (std::size_t r = 0; r < rows.size(); ++r) {
    fuzz::require(fuzz::same_bits(again[r].t_s, rows[r].t_s), "time comes back to the last bit");
    fuzz::require(again[r].present == rows[r].present, "absent samples stay absent");
    for (std::size_t f = 0; f < kFingerCount; ++f)
      fuzz::require(again[r].wrench_C[f].force == rows[r].wrench_C[f].force &&
                        again[r].wrench_C[f].torque == rows[r].wrench_C[f].torque,
                    "wrenches come back");
  }
  return 0;
}
