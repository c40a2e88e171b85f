// SPDX-License-Identifier: GPL-3.0-or-later
// A grip is held and let go on cue; perhaps the hand opens then.
#pragma once

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct GripReleaseSpec {
  Aim aim;
  double level = 0.25;
  double rise_s = 2.0;        ///< time to come to the level
  double least_wait_s = 1.0;  ///< on the level: a foreperiod that cannot be foreseen
  double most_wait_s = 3.0;
  double after_s = 6.0;  ///< relaxed after the cue: release is measured
  bool open = false;     ///< the cue is "open": force against the straps
  int repetitions = 5;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
