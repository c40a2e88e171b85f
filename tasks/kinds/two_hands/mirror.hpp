// SPDX-License-Identifier: GPL-3.0-or-later
// One hand works, the other one rests: how much of the effort overflows into it. People read "other
// hand at rest"; it is no mirror therapy.
#pragma once

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct MirrorSpec {
  enum class Active : std::uint8_t { left, right, affected, other };
  Active active = Active::affected;
  double level = 0.25;  ///< of the maximum of the hand that works
  double band_fraction = 0.1;
  int repetitions = 3;
  double hold_s = 8.0;  ///< of each
  double rest_s = 8.0;  ///< before each, both hands relaxed

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
