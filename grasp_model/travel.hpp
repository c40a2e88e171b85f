// SPDX-License-Identifier: GPL-3.0-or-later
// Travel limits: one degree of freedom stops at its limit, without bounce and without gain of
// energy, exactly at the crossing inside the hold. SI units.
#pragma once

#include "grasp_model/zoh.hpp"

namespace isograsp {

/// Bounds of the travel.
struct Travel {
  double least = 0.0;
  double most = 0.0;
};

/// LinearStep::advance with stops: inside the hold the motion is followed to the crossing, stops
/// there and rests or leaves as the force says. Real-time safe; costs as `step` unless a stop or a
/// turning point lies within the hold.
[[nodiscard]] Motion advance_within(const Oscillator& oscillator, const LinearStep& step,
                                    const Travel& travel, double hold_s, Motion start,
                                    double force) noexcept;

}  // namespace isograsp
