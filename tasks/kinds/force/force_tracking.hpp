// SPDX-License-Identifier: GPL-3.0-or-later
// The force follows a target between two levels.
#pragma once

#include <vector>

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

struct ForceTrackingSpec {
  Aim aim;
  Waveform waveform;
  double least = 0.1;
  double most = 0.3;
  double lead_in_s = 2.0;    ///< constant at the first value of the target; not scored
  double duration_s = 30.0;  ///< of the target after it

  static const KindFacts kFacts;
};

/// Its measures (force_tracking_score.cpp).
[[nodiscard]] std::vector<Measure> score_force_tracking(const ForceTrackingSpec& spec,
                                                        const Record& record);

}  // namespace isograsp::tasks
