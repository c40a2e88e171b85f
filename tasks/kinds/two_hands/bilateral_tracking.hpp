// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands follow: the sum of their forces one target, each a target of its own, or the two by
// turns.
#pragma once

#include <string_view>
#include <vector>

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

struct BilateralTrackingSpec {
  enum class Goal : std::uint8_t {
    sum,       ///< both together, however they share it
    each,      ///< each its part: `ratio_left`
    antiphase  ///< one presses while the other lets go
  };
  Goal goal = Goal::sum;
  double ratio_left = 0.5;  ///< of goal `each`: part of the left hand
  bool each_shown = true;   ///< the force of each hand is on the screen; of `sum` beside their sum
  Scale scale = Scale::of_maximum;  ///< of the maxima of both hands; antiphase: of its own
  double band_fraction = 0.1;       ///< half of what counts as on the target
  Waveform waveform;
  double least = 0.1;
  double most = 0.3;
  double lead_in_s = 2.0;    ///< constant at the first value of the target; not scored
  double duration_s = 30.0;  ///< of the target after it

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
