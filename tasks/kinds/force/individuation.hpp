// SPDX-License-Identifier: GPL-3.0-or-later
// One digit is asked to press; the forces of the others are measured.
#pragma once

#include <vector>

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct IndividuationSpec {
  Aim aim;  ///< its channel is not used: each digit in turn
  std::vector<Finger> digits{Finger::thumb, Finger::index, Finger::middle};
  std::vector<double> levels{0.2};
  double rest_s = 1.5;  ///< before each: the forces from which changes count
  double rise_s = 1.5;
  double hold_s = 2.0;
  int repetitions = 3;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
