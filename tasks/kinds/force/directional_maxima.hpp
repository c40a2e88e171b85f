// SPDX-License-Identifier: GPL-3.0-or-later
// A maximum of every named digit in every named direction, one after the other.
#pragma once

#include <vector>

#include "hand/force_channel.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct DirectionalMaximaSpec {
  std::vector<Finger> digits;
  std::vector<Direction> directions;
  double lead_in_s = 1.0;
  double push_s = 3.0;
  double rest_s = 3.0;  ///< relaxed, after each
  double window_s = 0.5;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
