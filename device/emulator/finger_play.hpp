// SPDX-License-Identifier: GPL-3.0-or-later
// What the fingers on emulated sensors do.
#pragma once

#include <vector>

#include "hand/finger.hpp"

namespace isograsp {

/// Wrenches in contact frames from times t_s on, each until the next. After the last row the play
/// begins again (repeat) or the last row holds.
struct FingerPlay {
  std::vector<double> t_s;  ///< strictly increasing, from 0
  std::vector<FingerWrenches> wrench_C;
  bool repeat = false;
  double duration_s = 0.0;  ///< of one round, for repeat

  [[nodiscard]] const FingerWrenches& at(double play_time_s) const noexcept;
};

}  // namespace isograsp
