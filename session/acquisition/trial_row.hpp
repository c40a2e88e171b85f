// SPDX-License-Identifier: GPL-3.0-or-later
// One frame of a trial as it is recorded: a row of numbers, and the columns that they stand in.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "session/acquisition/snapshot.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

/// What does not change within a trial and is stored beside its signals; NaN: not known.
struct TrialConstants {
  double resolution_N = tasks::kNotMeasured;     ///< coarsest step of a force component
  double device_delay_s = tasks::kNotMeasured;   ///< of the sensors and their filters
  double display_delay_s = tasks::kNotMeasured;  ///< from the program to the light
};

/// One frame as the acquisition has it at hand: what the columns are filled from.
struct TrialFrame {
  double t_s;                 ///< since the trial began; runs on while paused
  const FingerFrame& forces;  ///< zeroed; held values stand in where flagged
  const NetPush& push;
  tasks::Phase phase;  ///< `paused` while the task stands still, else that of the task
  const tasks::TaskView& task;
  const TrialConstants& constants;
  const ObjectState& object;  ///< at t_s, before this frame's wrench acts
  const GraspWrench& grasp;
  double lateness_s;
  double compute_s;  ///< of the frame before this one: its own is not over yet
};

/// One row: the values of all groups, one after the other.
class TrialRow {
 public:
  /// A task with an object has 102 columns; a test fails where a new one finds no room.
  static constexpr std::size_t kMostColumns = 112;

  [[nodiscard]] std::span<const double> values() const noexcept { return {values_.data(), size_}; }
  void clear() noexcept { size_ = 0; }
  /// @pre there is room
  void add(double value) noexcept { values_[size_++] = value; }

 private:
  std::array<double, kMostColumns> values_;
  std::size_t size_ = 0;
};

/// The stored columns of a trial; the "object" group only if there is an object.
[[nodiscard]] std::vector<storage::SignalGroup> signal_groups(bool has_object);

/// Fills `row` with one value per column of signal_groups(has_object), in that order. Real-time
/// safe.
void write_row(const TrialFrame& frame, bool has_object, TrialRow& row) noexcept;

}  // namespace isograsp::session
