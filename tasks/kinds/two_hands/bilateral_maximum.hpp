// SPDX-License-Identifier: GPL-3.0-or-later
// The largest grip force of each hand alone, then of both at once: what a hand can do, and whether
// it can do it beside the other.
#pragma once

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct BilateralMaximumSpec {
  double lead_in_s = 2.0;  ///< at rest
  double squeeze_s = 3.0;  ///< of each of the three efforts
  double rest_s = 60.0;    ///< between them
  double window_s = 0.5;   ///< best moving mean over this window counts

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
