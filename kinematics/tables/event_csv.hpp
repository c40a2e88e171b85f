// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of how targets ended, and of the targets by which movements are scored (docs/markers.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "kinematics/bands.hpp"
#include "kinematics/movement.hpp"
#include "kinematics/pose_task.hpp"

namespace isograsp {

/// posture, cue_s, enter_s, done_s, time_s, position_error_m, angle_error_rad; what a target did
/// not come to is empty.
[[nodiscard]] Result<void> write_pose_events(const std::string& path, const PoseTask& task,
                                             std::span<const PoseEvent> events);

/// posture, cue_s, matched_s, ref_x_m, ref_y_m, ref_z_m, ref_qw, ref_qx, ref_qy, ref_qz. matched_s
/// is empty where the target was not reached. Errors name file, line and column.
[[nodiscard]] Result<std::vector<PoseTarget>> read_pose_targets(const std::string& path);

/// posture, channel, tau, n, mean, sd.
[[nodiscard]] Result<void> write_bands(const std::string& path, std::span<const BandPoint> band);

}  // namespace isograsp
