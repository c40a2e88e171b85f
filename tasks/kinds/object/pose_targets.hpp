// SPDX-License-Identifier: GPL-3.0-or-later
// The object is brought to a series of poses, each held inside its tolerance. SI units, radians.
#pragma once

#include <string>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct PoseTarget {
  Vec3 p_WT = Vec3::Zero();  ///< [m]
  double angle_rad = 0.0;    ///< about world z
  double hold_s = 0.0;       ///< uninterrupted time inside the tolerance that counts as reached
  bool level = false;        ///< a transport: tilt on the way here is measured
};

struct PoseTargetsSpec {
  std::string scene;  ///< name of a scene file, beside the task file or in the library
  double position_tolerance_m = 0.02;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  double time_limit_s = 60.0;                       ///< per target
  std::vector<PoseTarget> targets;

  static const KindFacts kFacts;
};

/// Its measures (pose_targets_score.cpp).
[[nodiscard]] std::vector<Measure> score_pose_targets(const PoseTargetsSpec& spec,
                                                      const Record& record);

}  // namespace isograsp::tasks
