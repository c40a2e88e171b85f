// SPDX-License-Identifier: GPL-3.0-or-later
// The drinking task, once: reach for a glass, bring it to the mouth, drink, put it back, bring the
// hand back (kinematics/measures/drinking.hpp). Markers alone are looked at: no brace, no start
// posture, no rigid bodies.
#pragma once

#include <array>
#include <string>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

/// Whose markers: the first three are needed.
enum class DrinkingPart : std::uint8_t { hand, glass, face, trunk, shoulder, elbow, wrist };
inline constexpr std::size_t kDrinkingPartCount = 7;
inline constexpr std::size_t kNeededDrinkingParts = 3;

struct DrinkingSpec {
  /// Names as the rig has them; empty: not measured.
  std::array<std::string, kDrinkingPartCount> markers{"HAND",     "GLASS", "FACE", "TRUNK",
                                                      "SHOULDER", "ELBOW", "WRIST"};
  double lead_in_s = 2.0;    ///< the hand lies still: where the movement starts from
  double duration_s = 20.0;  ///< for one drink, to the hand's return

  static const KindFacts kFacts;
};

}  // namespace isograsp::tasks
