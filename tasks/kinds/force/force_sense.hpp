// SPDX-License-Identifier: GPL-3.0-or-later
// A force is felt with feedback and made again without.
#pragma once

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct ForceSenseSpec {
  Aim aim;
  double level = 0.2;
  double learn_s = 5.0;
  double pause_s = 3.0;
  double reproduce_s = 5.0;
  double window_s = 2.0;  ///< the end of the reproduction that counts
  int repetitions = 3;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
