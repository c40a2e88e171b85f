// SPDX-License-Identifier: GPL-3.0-or-later
// A real object is brought to one reference pose after the other (Kurillo et al., isotonic part;
// kinematics/pose_task.hpp). The references are postures of a reference subject, adapted to the
// size of this arm by its start posture (kinematics/postures.hpp). SI units, radians.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hand/arm_links.hpp"
#include "kinematics/pose_task.hpp"
#include "kinematics/postures.hpp"
#include "tasks/kind_spec.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

struct PoseMatchingSpec {
  std::string postures;  ///< name of a file of postures, beside the task or in the library
  /// Instead of a file: postures of the person's own active range of this angle, measured before in
  /// the session (kinematics: own_range_postures).
  std::optional<LinkAngle> own_range;
  std::vector<std::string> sequence;  ///< names of postures, `repeats` times
  int repeats = 1;
  double way = 1.0;  ///< how far from the initial posture to the named one, 0 … 1
  SizeScale scale = SizeScale::none;
  double position_tolerance_m = 0.015;
  double angle_tolerance_rad = 0.17453292519943295;  ///< 10 degrees
  double hold_s = 0.3;     ///< less would count an object that flies through
  double display_s = 2.0;  ///< from reached to the next reference
  double time_limit_s = 15.0;

  [[nodiscard]] std::size_t targets() const noexcept {
    return sequence.size() * static_cast<std::size_t>(repeats);
  }

  static const KindFacts kFacts;
};

/// What the task is for this arm: the references of the spec, in the order of its targets.
/// Errors: the postures lack one that the sequence names, or the arm is not known.
[[nodiscard]] Result<PoseTask> pose_task_of(const PoseMatchingSpec& spec,
                                            const std::optional<ArmPostures>& arm);

/// Its measures (pose_matching_score.cpp).
[[nodiscard]] std::vector<Measure> score_pose_matching(const PoseMatchingSpec& spec,
                                                       const Record& record);

}  // namespace isograsp::tasks
