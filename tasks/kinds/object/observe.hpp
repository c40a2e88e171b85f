// SPDX-License-Identifier: GPL-3.0-or-later
// Free handling of an object for a fixed time: recorded data, familiarisation.
#pragma once

#include <string>
#include <vector>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct ObserveSpec {
  std::string scene;
  double duration_s = 30.0;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
