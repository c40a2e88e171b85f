// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: one factory per kind of task; each state machine lives in its own file.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "tasks/task.hpp"

namespace isograsp {

[[nodiscard]] std::unique_ptr<Task> make_rest(const RestSpec& spec, const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_maximum(const MaximumSpec& spec,
                                                 const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_force_tracking(const ForceTrackingSpec& spec,
                                                        const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_pose_targets(const PoseTargetsSpec& spec,
                                                      const TaskContext& context);
[[nodiscard]] std::unique_ptr<Task> make_observe(const ObserveSpec& spec,
                                                 const TaskContext& context);

/// Whole frames that last `duration_s`; the epsilon keeps 0.3 s / 0.1 s at 3 frames, not 4.
[[nodiscard]] inline std::int64_t frames_in(double duration_s, double period_s) noexcept {
  constexpr double kRoundingSlack = 1e-9;
  return static_cast<std::int64_t>(std::ceil(duration_s / period_s - kRoundingSlack));
}

}  // namespace isograsp
