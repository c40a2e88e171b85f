// SPDX-License-Identifier: GPL-3.0-or-later
// Finger forces as a CSV file (docs/file_formats.md): t_s and, per finger, three forces [N] and
// three torques [N m] in the contact frame, pressing +z.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/csv.hpp"
#include "core/result.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// One row. A finger without a valid sample in this row has present = false and a zero wrench.
struct FingerForcesRow {
  double t_s = 0.0;
  FingerWrenches wrench_C{};
  std::array<bool, kFingerCount> present{};
};

/// Streams the rows of a finger-forces file in constant memory.
class FingerForcesReader {
 public:
  /// Missing torque columns count as zero. `required[f]`: the file must have the forces of finger
  /// f. `prefix` stands before the names of its columns: "left_" in a file of two hands.
  [[nodiscard]] static Result<FingerForcesReader> open(
      const std::string& path, std::array<bool, kFingerCount> required = {false, false, false},
      std::string prefix = "");

  /// False at the end. Checks increasing time and half-empty samples.
  [[nodiscard]] Result<bool> next(FingerForcesRow& row);

  [[nodiscard]] bool has(Finger finger) const noexcept {
    return axes_[index_of(finger)][0].has_value();
  }
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept {
    return csv_.comments();
  }
  [[nodiscard]] int line() const noexcept { return csv_.line(); }
  [[nodiscard]] const std::string& path() const noexcept { return csv_.path(); }

 private:
  FingerForcesReader(CsvReader csv, std::string prefix)
      : csv_(std::move(csv)), prefix_(std::move(prefix)) {}
  [[nodiscard]] std::string column_of(Finger finger, std::size_t axis) const;

  CsvReader csv_;
  std::string prefix_;
  std::size_t time_ = 0;
  /// Column of each axis; nothing: the file has none.
  std::array<std::array<std::optional<std::size_t>, 6>, kFingerCount> axes_{};
  std::vector<double> fields_;
  std::optional<double> previous_t_s_;
};

/// The grid of a file's times: regular if every step equals the first within 4 ulp of the largest
/// |t|; then every hold is exactly the first step.
struct TimeGrid {
  bool regular = false;
  double hold_s = 0.0;  ///< t_1 - t_0
};
/// Looks at the times alone; other columns are checked by the reader. At least two rows are
/// required.
[[nodiscard]] Result<TimeGrid> read_time_grid(const std::string& path);

/// Names of the columns in the standard order: t_s, thumb_fx_N … middle_tz_Nm.
[[nodiscard]] std::vector<std::string> finger_forces_columns();
/// Appends one line in that order; the fields of a finger with missing flags stay empty.
void append_finger_forces(std::string& text, const FingerForcesRow& row);

}  // namespace isograsp
