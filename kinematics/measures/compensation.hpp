// SPDX-License-Identifier: GPL-3.0-or-later
// How much the rest of the body, or the device, moves with a movement of the arm: elbow, trunk and
// brace of a rig ([score] elbow, trunk, brace). It stands beside the score, never in it. Positions
// in m, angles in rad, behind the low-pass of kinematics/measures/zero_phase.hpp. Formulas:
// docs/measures.md, "Movements of an arm".
#pragma once

#include <span>
#include <vector>

#include "core/result.hpp"
#include "kinematics/movement.hpp"

namespace isograsp {

/// An elbow that moved further within a movement means that the upper arm turned what is called the
/// forearm's turn.
inline constexpr double kUpperArmMoved_m = 0.020;
/// A brace that moved further since the start of the record: the device is no longer where it was.
inline constexpr double kDeviceMoved_m = 0.005;
inline constexpr double kDeviceMoved_rad = 0.034906585039886591;  ///< 2 degrees

struct MovementCompensation {
  // From the first row of the movement: of the elbow in the brace (in the world, if the rig names
  // no brace), of the trunk in the world.
  Valued elbow_path;          ///< m, its whole way
  Valued elbow_displacement;  ///< m, the largest distance
  Valued trunk_displacement;  ///< m, likewise
  Valued trunk_lean;          ///< rad, of what was vertical at first (`[view] up`)
  Valued trunk_rotation;      ///< rad, of the trunk about any axis
  // From the first pose of the brace in the record.
  Valued brace_displacement;  ///< m
  Valued brace_rotation;      ///< rad
  /// "upper arm moved", "device moved", "trunk not measured": to be said beside the score.
  std::vector<Text> notes;
};

/// One for each target. Errors: the rig has no [score], or a frame is not in the series.
[[nodiscard]] Result<std::vector<MovementCompensation>> movement_compensation(
    const Rig& rig, const PoseSeries& series, std::span<const PoseTarget> targets);

/// elbow_path, elbow_displacement (channel "elbow"), trunk_displacement, trunk_lean, trunk_rotation
/// ("trunk"), brace_displacement, brace_rotation ("brace").
[[nodiscard]] std::vector<MovementMeasure> compensation_measures(
    std::span<const MovementCompensation> movements);

}  // namespace isograsp
