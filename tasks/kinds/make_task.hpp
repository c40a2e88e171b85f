// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: one factory per kind of task with an object; each state machine lives in its
// own file.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "tasks/task.hpp"

namespace isograsp::tasks {

[[nodiscard]] std::unique_ptr<Task> make_pose_targets(const PoseTargetsSpec& spec,
                                                      const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_pose_tracking(const PoseTrackingSpec& spec,
                                                       const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_pick_place(const PickPlaceSpec& spec,
                                                    const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_observe(const ObserveSpec& spec,
                                                 const TaskContext& context);

/// How near is near enough.
struct PoseTolerance {
  double position_m = 0.0;
  double angle_rad = 0.0;
  [[nodiscard]] bool holds(const Pose& target, const Pose& object) const noexcept {
    return (object.p_WO - target.p_WO).norm() <= position_m &&
           angle_between(target.q_WO, object.q_WO) <= angle_rad;
  }
};

/// Whole frames that last `duration_s`; the epsilon keeps 0.3 s / 0.1 s at 3 frames, not 4.
[[nodiscard]] inline std::int64_t frames_in(double duration_s, double period_s) noexcept {
  constexpr double kRoundingSlack = 1e-9;
  return static_cast<std::int64_t>(std::ceil(duration_s / period_s - kRoundingSlack));
}

}  // namespace isograsp::tasks
