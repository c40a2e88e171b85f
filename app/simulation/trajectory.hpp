// SPDX-License-Identifier: GPL-3.0-or-later
// The trajectory of an object that measured forces move, as `isograsp simulate` writes it
// (docs/file_formats.md): state, wrench, and whether each contact touches.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/simulation/table_files.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp::app {

class TrajectoryWriter {
 public:
  /// `contacts`: names of the last columns.
  [[nodiscard]] static Result<TrajectoryWriter> create(const std::string& path,
                                                       std::span<const std::string> contacts);
  /// @pre touching.size() == contacts.size()
  void add(double t_s, const ObjectState& state, const Wrench& F_O_W,
           std::span<const bool> touching);
  [[nodiscard]] Result<void> commit() { return rows_.commit(); }

 private:
  explicit TrajectoryWriter(NumberRows rows) : rows_(std::move(rows)) {}

  NumberRows rows_;
};

/// What became of the holds, for the notes at the end.
struct HoldCount {
  std::size_t all = 0;
  std::size_t frozen = 0;
  std::size_t inexact = 0;

  void print_notes() const;
};

}  // namespace isograsp::app
