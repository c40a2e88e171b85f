// SPDX-License-Identifier: GPL-3.0-or-later
// A level is held for as long as asked.
#pragma once

#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct FatigueSpec {
  Aim aim;
  double level = 0.5;
  double rise_s = 2.0;
  double hold_s = 30.0;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
