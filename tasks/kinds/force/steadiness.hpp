// SPDX-License-Identifier: GPL-3.0-or-later
// Levels held one after the other; the spread of the force around its trend is what counts.
#pragma once

#include <vector>

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct SteadinessSpec {
  Aim aim;
  std::vector<double> levels{0.05, 0.25};
  double rise_s = 3.0;    ///< ramp to the level, not scored
  double settle_s = 2.0;  ///< on the level, not scored
  double hold_s = 12.0;
  double rest_s = 5.0;  ///< relaxed, after each level

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
