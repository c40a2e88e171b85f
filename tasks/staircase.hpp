// SPDX-License-Identifier: GPL-3.0-or-later
// Adaptive difficulty, for training only: the weighted up-down staircase (Kaernbach 1991). The
// level rises by `up` after a success and falls by `down` after a failure; it settles where up * p
// = down * (1 - p), at p = 75 % success. Levels run from 0 (easiest) to 1 (hardest).
#pragma once

#include <algorithm>

namespace isograsp::tasks {

struct Staircase {
  static constexpr double kSuccess = 0.75;  ///< within the 70 … 80 % that keep people trying
  static constexpr double kDown = 0.15;
  static constexpr double kUp = kDown * (1.0 - kSuccess) / kSuccess;

  double level = 0.0;

  /// After a trial at `level`. Trials with a device fault or a helping hand are not for here.
  [[nodiscard]] constexpr Staircase after(bool success) const noexcept {
    return {std::clamp(level + (success ? kUp : -kDown), 0.0, 1.0)};
  }
};

}  // namespace isograsp::tasks
