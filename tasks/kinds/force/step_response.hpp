// SPDX-License-Identifier: GPL-3.0-or-later
// From one level to another at once, after a wait that cannot be foreseen.
#pragma once

#include <vector>

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct StepResponseSpec {
  Aim aim;
  double from = 0.1;
  std::vector<double> to{0.3};
  double least_wait_s = 1.0;
  double most_wait_s = 3.0;
  double hold_s = 4.0;
  int repetitions = 3;  ///< of every level

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
