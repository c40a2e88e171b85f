// SPDX-License-Identifier: GPL-3.0-or-later
// A real object is kept on a reference that moves from posture to posture
// (kinematics/reference_path.hpp), adapted to the size of this arm by its start posture. SI units.
#pragma once

#include <string>
#include <vector>

#include "kinematics/postures.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct PoseFollowingSpec {
  std::string postures;  ///< name of a file of postures, beside the task or in the library
  std::vector<std::string> sequence;  ///< names of postures: one round, which ends at the first
  double leg_s = 4.0;                 ///< from one posture to the next
  int rounds = 3;
  double way = 1.0;  ///< how far from the initial posture to the named one, 0 … 1
  SizeScale scale = SizeScale::none;
  double lead_in_s = 3.0;  ///< the reference stands where it begins, not scored

  [[nodiscard]] double moving_s() const noexcept {
    return leg_s * static_cast<double>(sequence.size()) * rounds;
  }

  static const KindFacts kFacts;
};

/// Its measures (pose_following_score.cpp).
[[nodiscard]] std::vector<Measure> score_pose_following(const PoseFollowingSpec& spec,
                                                        const Record& record);

}  // namespace isograsp::tasks
