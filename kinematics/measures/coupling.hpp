// SPDX-License-Identifier: GPL-3.0-or-later
// How forearm and fingers share a movement: do they turn together, who is first, how near to the
// own limit did it begin, and how long did it take to see what is asked and to do it. Times in s,
// angles in rad. Formulas: docs/measures.md, "Movements of an arm".
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "kinematics/movement.hpp"
#include "kinematics/postures.hpp"

namespace isograsp {

struct MovementCoupling {
  // Of the share of the link that ends at the object (r_angle) on that of the forearm.
  Valued slope;
  Valued r_squared;
  Valued lead;  ///< t10 of the forearm minus its own [s]; above 0: it is first
  std::vector<Valued>
      range_margin;         ///< [link of the rig] to the nearest own limit at the cue [rad]
  Valued recognition_time;  ///< from the cue until the object turns (t10 of the sync link) [s]
  Valued movement_time;     ///< from there to the match [s]
};

/// The link from the hand to the object: the first whose child is the object and whose parent is a
/// frame. @pre the rig has a [score]
[[nodiscard]] std::optional<std::size_t> link_to_object(const Rig& rig);

/// One for each movement. Errors: an own range is not of a link of the rig, or a frame is not in
/// the series. @pre scores are of this rig and series
[[nodiscard]] Result<std::vector<MovementCoupling>> movement_coupling(
    const Rig& rig, const PoseSeries& series, const MovementScores& scores,
    std::span<const OwnRange> ranges);

/// coupling_slope, coupling_r_squared, lead (channel: the link to the object, or "object" if there
/// is none), range_margin (channel: the link), recognition_time, movement_time (channel "task").
[[nodiscard]] std::vector<MovementMeasure> coupling_measures(
    const Rig& rig, std::span<const MovementCoupling> movements);

}  // namespace isograsp
