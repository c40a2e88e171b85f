// SPDX-License-Identifier: GPL-3.0-or-later
// The target moves, or jumps, in one to six degrees of freedom. SI units, radians.
#pragma once

#include <string>
#include <vector>

#include "tasks/kind_spec.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

struct PoseTrackingSpec {
  struct Axis {
    int axis = 0;  ///< 0 … 5: x y z [m], turns about world x y z [rad]
    double least = 0.0;
    double most = 0.0;
    Waveform waveform;
  };
  std::string scene;
  std::vector<Axis> axes;
  double lead_in_s = 2.0;
  double duration_s = 30.0;

  static const KindFacts kFacts;
};

/// Its measures (pose_tracking_score.cpp).
[[nodiscard]] std::vector<Measure> score_pose_tracking(const PoseTrackingSpec& spec,
                                                       const Record& record);

}  // namespace isograsp::tasks
