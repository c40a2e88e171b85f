// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of tracked hands as tables: t_s, hand, tracked, confidence, then JOINT_x_m, JOINT_y_m,
// JOINT_z_m of the joints of hand/tracked_hand.hpp. What is not given is an empty field. Several
// hands are several rows with one time.
#pragma once

#include <string>
#include <vector>

#include "core/files.hpp"
#include "core/result.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp {

/// A whole recording. Errors name file, line and column: an unknown column, a part of a position
/// that is empty, a number that is none, times of one hand that do not increase. JOINT_radius_m are
/// passed over.
[[nodiscard]] Result<std::vector<HandFrame>> read_hand_csv(const std::string& path);

/// Whether a file begins like such a table; false also where it cannot be read.
[[nodiscard]] bool begins_like_hand_csv(const std::string& path);

/// Writes row by row, in constant memory.
class HandCsvWriter {
 public:
  [[nodiscard]] static Result<HandCsvWriter> create(const std::string& path);
  void write(const HandFrame& frame);
  /// Without it no file is left under the path.
  [[nodiscard]] Result<void> commit() { return file_.commit(); }

 private:
  explicit HandCsvWriter(FileWriter file) : file_(std::move(file)) {}
  FileWriter file_;
  std::string text_;
};

}  // namespace isograsp
