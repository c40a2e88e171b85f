// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/arm/segment_poses.hpp"

#include <cmath>

namespace isograsp::tasks {

SegmentPoses::SegmentPoses(const Signals& signals, const columns::OfAxes& position,
                           const columns::OfComponents& attitude) {
  for (std::size_t a = 0; a < 3; ++a) p_[a] = signals.column(position[a]);
  for (std::size_t i = 0; i < 4; ++i) q_[i] = signals.column(attitude[i]);
}

Pose SegmentPoses::at(std::size_t row) const {
  for (const auto& column : p_)
    if (column.empty() || std::isnan(column[row])) return missing_pose();
  for (const auto& column : q_)
    if (column.empty() || std::isnan(column[row])) return missing_pose();
  return {{p_[0][row], p_[1][row], p_[2][row]},
          Quat(q_[0][row], q_[1][row], q_[2][row], q_[3][row])};
}

SegmentPoses object_poses(const Signals& signals) {
  const auto& object = columns::segment_pose[index_of(ArmSegment::object)];
  return {signals, object.position, object.attitude};
}

SegmentPoses reference_poses(const Signals& signals) {
  return {signals, columns::reference_position, columns::reference_attitude};
}

std::vector<std::string> columns_of_object_and_reference() {
  std::vector<std::string> names;
  const auto& object = columns::segment_pose[index_of(ArmSegment::object)];
  for (const auto& axes : {object.position, columns::reference_position})
    for (const Column& column : axes) names.emplace_back(column);
  for (const auto& parts : {object.attitude, columns::reference_attitude})
    for (const Column& column : parts) names.emplace_back(column);
  return names;
}

std::vector<std::string> columns_of_pose_trial() {
  std::vector<std::string> names = columns_of_object_and_reference();
  names.emplace_back(columns::target_index);
  return names;
}

statistics::Computed seen_percent(const Record& record) {
  const SegmentPoses object = object_poses(record.signals());
  double seen_s = 0.0;
  double all_s = 0.0;
  for (std::size_t row = 0; row < record.rows(); ++row) {
    if (record.phase(row) == Phase::lead_in || record.phase(row) == Phase::done) continue;
    all_s += record.hold_s(row);
    if (!is_missing(object.at(row))) seen_s += record.hold_s(row);
  }
  if (!(all_s > 0.0)) return "no samples"_text;
  constexpr double kPercent = 100.0;
  return kPercent * seen_s / all_s;
}

Measure seen(const Record& record, const Section& section) {
  return make_measure(
      "seen", "object", "%", section,
      section.reason.empty() ? seen_percent(record) : statistics::Computed("no samples"_text));
}

}  // namespace isograsp::tasks
