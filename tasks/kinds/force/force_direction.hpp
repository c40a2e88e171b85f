// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of given size and direction, for one digit or several at once.
#pragma once

#include <array>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/aim.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct ForceDirectionTarget {
  std::array<bool, kFingerCount> asked{};
  std::array<Vec3, kFingerCount> direction_C{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< unit
  double level = 0.2;
};

struct ForceDirectionSpec {
  Aim aim;  ///< its channel is not used
  std::vector<ForceDirectionTarget> targets;
  double rise_s = 2.0;
  double hold_s = 3.0;
  double rest_s = 2.0;
  int repetitions = 1;

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
