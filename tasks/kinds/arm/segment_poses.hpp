// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: poses of the segments of an arm as a trial recorded them.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "hand/arm_columns.hpp"
#include "kinematics/attitude.hpp"
#include "tasks/record.hpp"

namespace isograsp::tasks {

/// Poses of a segment, row by row; missing where a field is empty. Refers to the signals.
class SegmentPoses {
 public:
  SegmentPoses(const Signals& signals, const columns::OfAxes& position,
               const columns::OfComponents& attitude);

  /// There are such columns.
  [[nodiscard]] bool known() const noexcept { return !p_[0].empty() && !q_[0].empty(); }
  [[nodiscard]] Pose at(std::size_t row) const;

 private:
  std::array<std::span<const double>, 3> p_;
  std::array<std::span<const double>, 4> q_;
};
[[nodiscard]] SegmentPoses object_poses(const Signals& signals);
[[nodiscard]] SegmentPoses reference_poses(const Signals& signals);

/// Names of all fields of both.
[[nodiscard]] std::vector<std::string> columns_of_object_and_reference();
/// Those and the number of the target: without them a trial of poses cannot be read.
[[nodiscard]] std::vector<std::string> columns_of_pose_trial();

/// Share of the time of the task in which the object was seen [%]; pauses out of sight count.
[[nodiscard]] statistics::Computed seen_percent(const Record& record);
/// The measure of that name, with the samples of a section.
[[nodiscard]] Measure seen(const Record& record, const Section& section);

}  // namespace isograsp::tasks
