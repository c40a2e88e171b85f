// SPDX-License-Identifier: GPL-3.0-or-later
// How far the person opens and closes the hand, without help and without an object: thumb-index
// gap, range of each digit, times of the movements.
#pragma once

#include <vector>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct HandOpeningSpec {
  double lead_in_s = 2.0;  ///< at rest, not scored
  int repetitions = 5;     ///< opened and closed so often
  double open_s = 4.0;     ///< of each
  double close_s = 4.0;

  static const KindFacts kFacts;
};

/// Its measures (hand_opening_score.cpp).
[[nodiscard]] std::vector<Measure> score_hand_opening(const HandOpeningSpec& spec,
                                                      const Record& record);

}  // namespace isograsp::tasks
