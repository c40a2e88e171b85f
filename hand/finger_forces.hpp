// SPDX-License-Identifier: GPL-3.0-or-later
// Finger forces as a table (docs/file_formats.md): t_s and, per finger, three forces [N] and
// three torques [N m] in the contact frame, pressing +z.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/tables/number_table.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// One row. A finger without a valid sample in this row has present = false and a zero wrench.
struct FingerForcesRow {
  double t_s = 0.0;
  FingerWrenches wrench_C{};
  std::array<bool, kFingerCount> present{};
};

/// Streams the rows of finger forces in constant memory.
class FingerForcesReader {
 public:
  /// Missing torque columns count as zero. `required[f]`: the table must have the forces of finger
  /// f. `prefix` stands before the names of its columns: "left_" in a table of two hands.
  [[nodiscard]] static Result<FingerForcesReader> open(std::unique_ptr<TableReader> table,
                                                       std::array<bool, kFingerCount> required = {},
                                                       std::string prefix = "");
  /// A CSV file.
  [[nodiscard]] static Result<FingerForcesReader> open(
      const std::string& path, std::array<bool, kFingerCount> required = {});

  /// False at the end. Checks increasing time and half-empty samples.
  [[nodiscard]] Result<bool> next(FingerForcesRow& row);

  [[nodiscard]] bool has(Finger finger) const noexcept {
    return axes_[index_of(finger)][0].has_value();
  }
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept {
    return table_->comments();
  }

 private:
  FingerForcesReader(std::unique_ptr<TableReader> table, std::string prefix)
      : table_(std::move(table)), prefix_(std::move(prefix)) {}
  [[nodiscard]] std::string column_of(Finger finger, std::size_t axis) const;

  std::unique_ptr<TableReader> table_;
  std::string prefix_;
  std::size_t time_ = 0;
  /// Column of each axis; nothing: the file has none.
  std::array<std::array<std::optional<std::size_t>, 6>, kFingerCount> axes_{};
  std::vector<double> fields_;
  std::optional<double> previous_t_s_;
};

/// The grid of a table's times: regular if every step equals the first within 4 ulp of the largest
/// |t|; then every hold is exactly the first step.
struct TimeGrid {
  bool regular = false;
  double hold_s = 0.0;  ///< t_1 - t_0
};
/// Looks at the times alone; other columns are checked by the reader. At least two rows are
/// required.
[[nodiscard]] Result<TimeGrid> read_time_grid(const OpenTable& open);
/// Of a CSV file.
[[nodiscard]] Result<TimeGrid> read_time_grid(const std::string& path);

/// Names of the columns in the standard order: t_s, thumb_fx_N … middle_tz_Nm.
[[nodiscard]] std::vector<std::string> finger_forces_columns();
/// Appends one line in that order; the fields of a finger with missing flags stay empty.
void append_finger_forces(std::string& text, const FingerForcesRow& row);

}  // namespace isograsp
