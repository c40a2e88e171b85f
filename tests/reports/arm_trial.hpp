// SPDX-License-Identifier: GPL-3.0-or-later
// A made trial of an arm that brings an object to "screw" and back: 0.3 s of rest, a turn about z
// of which forearm, wrist and fingers each do a part, then still until the next target.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/signals.hpp"
#include "hand/arm_columns.hpp"
#include "kinematics/pose_task.hpp"
#include "tasks/task_progress.hpp"

namespace isograsp::test {

struct ArmTrial {
  int targets = 6;
  double turn_rad = 1.0;
  double off_m = 0.0;     ///< how far the object stops from its reference
  double unseen_s = 0.0;  ///< of each movement, before it begins
  // At the end of each movement.
  double elbow_m = 0.0;
  double brace_m = 0.0;
  bool trunk = true;
};

/// 100 rows a second. Tolerances and times are those of the task's defaults.
inline Signals signals_of(const ArmTrial& trial) {
  constexpr double kStep_s = 0.01;
  constexpr double kRest_s = 0.3;
  constexpr double kMove_s = 1.5;
  constexpr std::array kShare{0.6, 0.3, 0.1};  // forearm, wrist, fingers
  const auto turned = [](double rad) { return Quat(std::cos(rad / 2), 0, 0, std::sin(rad / 2)); };
  PoseTask task;
  task.position_tolerance_m = 0.015;
  task.angle_tolerance_rad = 0.17453292519943295;
  task.hold_s = 0.3;
  task.time_limit_s = 15.0;
  for (int target = 0; target < trial.targets; ++target) {
    const double to_rad = target % 2 == 0 ? trial.turn_rad : 0.0;
    task.references.push_back({"", {Vec3(trial.off_m, 0, 0), turned(to_rad)}});
    task.targets.push_back(task.references.size() - 1);
  }
  std::vector<std::string> names{std::string(columns::t_s), std::string(columns::phase),
                                 std::string(columns::target_index), std::string(columns::matched)};
  const auto add_names = [&](const auto& position, const auto& attitude) {
    for (const Column& column : position) names.emplace_back(column);
    for (const Column& column : attitude) names.emplace_back(column);
  };
  std::vector<ArmSegment> segments;
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    if (const auto segment = static_cast<ArmSegment>(s);
        segment != ArmSegment::trunk || trial.trunk)
      segments.push_back(segment);
  for (const ArmSegment segment : segments)
    add_names(columns::segment_pose[index_of(segment)].position,
              columns::segment_pose[index_of(segment)].attitude);
  add_names(columns::reference_position, columns::reference_attitude);
  Signals signals(names);

  PoseTaskRun run(task);
  std::size_t shown = 0;
  double since_s = 0.0;
  for (int row = 0; !run.finished(); ++row) {
    const double s = std::clamp((since_s - kRest_s) / kMove_s, 0.0, 1.0);
    const double way = s * s * s * (10.0 + s * (6.0 * s - 15.0));
    const double done = shown % 2 == 0 ? way : 1.0 - way;
    const bool seen = !(since_s > 0.05 && since_s < 0.05 + trial.unseen_s);
    const auto angle = [&](double part) { return turned(part * done * trial.turn_rad); };
    const double t_s = kStep_s * row;
    std::vector<double> values{t_s, static_cast<double>(tasks::Phase::transport), 0.0, 0.0};
    const auto add = [&](const Vec3& p, const Quat& q, bool there) {
      for (const double value : {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()})
        values.push_back(there ? value : std::nan(""));
    };
    Pose object = missing_pose();
    for (const ArmSegment segment : segments) {
      switch (segment) {
        case ArmSegment::brace: add({trial.brace_m * done, 0, 0}, turned(0), true); break;
        case ArmSegment::elbow: add({trial.elbow_m * done, 0, 0}, turned(0), true); break;
        case ArmSegment::forearm: add(Vec3::Zero(), angle(kShare[0]), true); break;
        case ArmSegment::dorsum: add(Vec3::Zero(), angle(kShare[0] + kShare[1]), true); break;
        case ArmSegment::object:
          add(Vec3::Zero(), angle(1.0), seen);
          if (seen) object = {Vec3::Zero(), angle(1.0)};
          break;
        default: add(Vec3::Zero(), turned(0), true);
      }
    }
    run.step(t_s, object);
    if (run.finished()) break;
    values[2] = static_cast<double>(run.target());
    values[3] = run.matched() ? 1.0 : 0.0;
    const Pose& reference = task.references[run.target()].X_WR;
    add(reference.p, reference.q, true);
    signals.append_row(values);
    if (run.target() == shown) {
      since_s += kStep_s;
    } else {
      shown = run.target();
      since_s = 0.0;
    }
  }
  return signals;
}

}  // namespace isograsp::test
