// SPDX-License-Identifier: GPL-3.0-or-later
// The trajectory of an object that measured forces move, as `isograsp simulate` writes it
// (docs/file_formats.md): state, wrench, and whether each contact touches.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/csv.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp::app {

/// Prints rows straight into one block, which goes to the file when it is full.
class TrajectoryWriter {
 public:
  /// `contacts`: names of the last columns.
  TrajectoryWriter(FileWriter file, std::span<const std::string> contacts);

  /// @pre touching.size() == contacts.size()
  void add(double t_s, const ObjectState& state, const Wrench& F_O_W,
           std::span<const bool> touching);
  [[nodiscard]] Result<void> commit();

 private:
  void flush();

  FileWriter file_;
  std::vector<char> block_ = std::vector<char>(std::size_t{1} << 16);
  std::size_t used_ = 0;
};

/// What became of the holds, for the notes at the end.
struct HoldCount {
  std::size_t all = 0;
  std::size_t frozen = 0;
  std::size_t inexact = 0;

  void print_notes() const;
};

}  // namespace isograsp::app
