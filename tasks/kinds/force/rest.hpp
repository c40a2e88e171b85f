// SPDX-License-Identifier: GPL-3.0-or-later
// Hand in, relaxed: the resting force of each finger is measured and stored, never subtracted.
#pragma once

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct RestSpec {
  double duration_s = 10.0;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
