// SPDX-License-Identifier: GPL-3.0-or-later
// The drinking task, from markers: reach for a glass, bring it to the mouth, drink, put it back,
// bring the hand back. Positions in m, times in s, behind the low-pass of
// kinematics/measures/zero_phase.hpp. Which definitions are whose, and what markers cannot tell:
// docs/measures.md, "Drinking task".
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/measure.hpp"
#include "kinematics/attitude.hpp"
#include "kinematics/movement.hpp"

namespace isograsp {

/// One marker for each part, one position for each row, missing ones NaN. Hand, glass and face are
/// needed; of the others none at all means that they were not measured.
struct DrinkingMarkers {
  std::vector<double> t_s;  ///< strictly increasing
  std::vector<Vec3> hand;
  std::vector<Vec3> glass;
  std::vector<Vec3> face;
  std::vector<Vec3> trunk;
  std::vector<Vec3> shoulder;
  std::vector<Vec3> elbow;
  std::vector<Vec3> wrist;
};

inline constexpr std::array<std::string_view, 5> kDrinkingPhases{
    "reaching", "forward_transport", "drinking", "back_transport", "returning"};

struct DrinkingTask {
  Text reason;  ///< why the phases are not known; empty: they are
  /// When each phase begins and when the last one ends [s].
  std::array<double, kDrinkingPhases.size() + 1> phase_s{};
  /// total_movement_time (channel "task"), phase_time (each phase), peak_velocity,
  /// time_to_peak_velocity, elbow_extension, elbow_extension_rate (channel "reaching"),
  /// movement_units (channels "reaching_forward", "back_returning", "total"), trunk_displacement
  /// and reach (channel "trunk").
  std::vector<Measure> measures;
};

/// @pre as many positions as times, of each part that was measured
[[nodiscard]] DrinkingTask drinking_task(const DrinkingMarkers& markers);

}  // namespace isograsp
