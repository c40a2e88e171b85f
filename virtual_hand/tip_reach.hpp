// SPDX-License-Identifier: GPL-3.0-or-later
// Which angles bring the tip of a digit to a place. Pure, without allocation. SI units.
#pragma once

#include "virtual_hand/hand_pose.hpp"

namespace isograsp::virtual_hand {

/// Angles of digits at ease, half bent; of their tips many places are near.
inline constexpr DigitAngles kThumbAtEase{0.4, 0.4, 0.5, 0.4};
inline constexpr DigitAngles kFingerAtEase{0.0, 0.7, 0.7, 0.35};
[[nodiscard]] std::array<DigitAngles, kDigitCount> angles_at_ease() noexcept;

/// Turns a digit from where it is, within its limits, until its tip is as near to `goal_W` as it
/// comes; of all such angles nearly those that differ least from the ones at ease (a radian costs
/// as much as a millimetre of the tip). `steps`: of Gauss and Newton. Returns what is missing [m].
double reach_with_tip(const HandModel& hand, HandPose& pose, Digit digit, const Vec3& goal_W,
                      int steps) noexcept;

}  // namespace isograsp::virtual_hand
