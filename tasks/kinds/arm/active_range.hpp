// SPDX-License-Identifier: GPL-3.0-or-later
// How far the person turns one link of the arm, there and back, without help: the active range of
// motion.
#pragma once

#include "hand/arm_columns.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct ActiveRangeSpec {
  ArmLink link = ArmLink::forearm;
  int angle = 1;         ///< 1, 2 or 3, in the sequence of the rig
  double lead_in_s = 2;  ///< still, not scored
  double duration_s = 15;
  int repetitions = 3;  ///< that are asked for in this time

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
