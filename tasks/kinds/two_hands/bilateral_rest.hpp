// SPDX-License-Identifier: GPL-3.0-or-later
// Both hands relaxed: the resting force of each, above which what it does is counted.
#pragma once

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct BilateralRestSpec {
  double duration_s = 10.0;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
