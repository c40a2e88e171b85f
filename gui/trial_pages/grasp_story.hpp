// SPDX-License-Identifier: GPL-3.0-or-later
// Why a virtual object was held and why it was let go, digit by digit, from the rows of a stored
// trial alone: what the assistance decided (virtual_hand/assistance.hpp) and the numbers by which
// it did. Pure. SI units.
#pragma once

#include <QString>
#include <vector>

#include "core/signals.hpp"
#include "virtual_hand/grasp_criteria.hpp"

namespace isograsp::gui {

struct GraspEvent {
  enum class What : std::uint8_t {
    tied,     ///< a feasible grasp stood long enough
    pulled,   ///< the digit pulled harder than its tie holds
    alone,    ///< another one let go, and what was left is no grasp
    placed,   ///< another one let go of what had been placed
    helped,   ///< the object was let go for the person
    dropped,  ///< nothing held the object any more
    ended     ///< the placement is over
  };
  double t_s = 0.0;  ///< on the trial's own clock
  What what = What::tied;
  virtual_hand::DigitSet digits = 0;  ///< to whom it happened; `dropped`: 0
  // Of `pulled`: the pull at which it let go, and what a tie holds.
  double pull_N = 0.0;
  double limit_N = 0.0;
  // Of `tied`: the grasp by which it was, and its criteria.
  virtual_hand::GraspChoice grasp;
};

/// In the order of time. Empty: nothing was tied or dropped, or the trial has no such columns.
[[nodiscard]] std::vector<GraspEvent> grasp_story(const Signals& signals);

/// "Index finger: let go, pulled with 1.90 N > 1.20 N".
[[nodiscard]] QString words_of(const GraspEvent& event);

}  // namespace isograsp::gui
