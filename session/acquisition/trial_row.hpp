// SPDX-License-Identifier: GPL-3.0-or-later
// One frame of a trial as it is recorded: a row of numbers, and the columns that they stand in.
// An apparatus writes column and value in one line, to a Sink: the same lines give the names of the
// columns once a trial and their values every frame. A Sink has begin(name of a group) and
// put(column, value).
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/column.hpp"
#include "core/spatial.hpp"
#include "storage/records/session_store.hpp"
#include "tasks/task_progress.hpp"

namespace isograsp::session {

/// One row: the values of all groups, one after the other.
class TrialRow {
 public:
  /// A task with an object has 102 columns, an arm with 58 markers 255; a test fails where a new
  /// one finds no room.
  static constexpr std::size_t kMostColumns = 256;

  TrialRow() = default;
  /// Only what is there is copied.
  TrialRow(const TrialRow& other) noexcept { *this = other; }
  TrialRow& operator=(const TrialRow& other) noexcept {
    size_ = other.size_;
    std::copy_n(other.values_.begin(), size_, values_.begin());
    return *this;
  }

  [[nodiscard]] std::span<const double> values() const noexcept { return {values_.data(), size_}; }
  void clear() noexcept { size_ = 0; }
  /// @pre there is room
  void add(double value) noexcept { values_[size_++] = value; }

 private:
  std::array<double, kMostColumns> values_;
  std::size_t size_ = 0;
};

/// Collects the columns; values are of no interest.
struct ColumnNames {
  std::vector<storage::SignalGroup>& groups;
  void begin(std::string_view group) { groups.push_back({std::string(group), {}}); }
  void put(const Column& column, double) { groups.back().columns.emplace_back(column); }
};

/// Collects the values.
struct ColumnValues {
  TrialRow& row;
  void begin(std::string_view) noexcept {}
  void put(const Column&, double value) noexcept { row.add(value); }
};

/// What every trial records of a frame.
struct RowFrame {
  double t_s = 0.0;  ///< since the trial began; runs on while paused
  /// `paused` while the task stands still, else that of the task.
  tasks::Phase phase = tasks::Phase::lead_in;
  tasks::TaskProgress task;
  double lateness_s = 0.0;
  double compute_s = 0.0;  ///< of the frame before this one: its own is not over yet
};

/// A place, x y z.
template <class Sink>
void put_position(Sink& sink, const std::array<Column, 3>& axes, const Vec3& p) {
  for (std::size_t a = 0; a < 3; ++a) sink.put(axes[a], p[static_cast<Eigen::Index>(a)]);
}

/// A place and an attitude, quaternion w x y z.
template <class Sink>
void put_pose(Sink& sink, const std::array<Column, 3>& axes,
              const std::array<Column, 4>& components, const Pose& X) {
  put_position(sink, axes, X.p);
  const std::array<double, 4> value{X.q.w(), X.q.x(), X.q.y(), X.q.z()};
  for (std::size_t i = 0; i < 4; ++i) sink.put(components[i], value[i]);
}

/// The group "task" begins with it; what the apparatus knows of the task follows.
template <class Sink>
void put_progress(Sink& sink, const RowFrame& frame) {
  sink.begin("task");
  sink.put(columns::t_s, frame.t_s);
  sink.put(columns::task_time_s, frame.task.task_time_s);
  sink.put(columns::phase, static_cast<double>(frame.phase));
}

/// The last group.
template <class Sink>
void put_timing(Sink& sink, const RowFrame& frame) {
  sink.begin("timing");
  sink.put(columns::lateness_s, frame.lateness_s);
  sink.put(columns::compute_s, frame.compute_s);
}

}  // namespace isograsp::session
