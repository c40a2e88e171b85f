// SPDX-License-Identifier: GPL-3.0-or-later
// A placement: an object is brought to a target, held there for a second and let go (Delrieu et
// al., task and measures; thresholds and what counts as a drop: docs/virtual_hand.md). Pure. SI
// units.
#pragma once

#include <optional>
#include <span>

#include "core/spatial.hpp"

namespace isograsp::virtual_hand {

struct PlacementRow {
  double t_s = 0.0;
  bool held = false;       ///< a digit is tied to it, or two touch it
  bool supported = false;  ///< it rests on table or support
  Pose X_WO;               ///< of the object
  Pose X_WT;               ///< of the target
};

struct PlacementRule {
  double distance_m = 0.010;
  double angle_rad = 0.2617993877991494;  ///< 15 degrees, between the main axes
  double stays_within = 1.5;              ///< times both, once it is there
  double hold_s = 1.0;
  double dropped_s = 0.25;  ///< not held for so long, or fallen on something before: a drop
};

/// Times from the first row; what an unfinished placement has not is nothing.
struct PlacementScore {
  bool completed = false;
  int fails = 0;                         ///< drops
  std::optional<double> manipulation_s;  ///< until the hold that was completed began
  std::optional<double> done_s;
  std::optional<double> hold_distance_m;  ///< means over that hold, weighted with time
  std::optional<double> hold_axis_angle_rad;
  std::optional<double> hold_geodesic_rad;
};

/// Angle between the main axes (z) of two attitudes; an axis has no direction [rad].
[[nodiscard]] double main_axis_angle(const Quat& a, const Quat& b) noexcept;

/// @pre rows in the order of time
[[nodiscard]] PlacementScore score_placement(std::span<const PlacementRow> rows,
                                             const PlacementRule& rule = {});

}  // namespace isograsp::virtual_hand
