// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands that are points on the screen take an object between them, carry it to a target, hold
// it there and let it go (Talvas et al.: double bubble, magnetic pinch, joint control). SI units,
// radians.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct BimanualPickPlaceSpec {
  /// The conditions of the source: how hands explore, and what holds the object.
  enum class Technique : std::uint8_t { clutch, bubble, clutch_pinch, bubble_pinch };
  struct Target {
    Vec3 p_WT = Vec3::Zero();  ///< [m]
  };
  std::string scene;  ///< of two hands, coupling "proxy"
  Technique technique = Technique::bubble_pinch;
  double edge_fraction = 0.15;                      ///< HandsCarry
  double affected_share = 0.5;                      ///< likewise; training alone changes it
  double position_tolerance_m = 0.02;               ///< of the object at its target
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  std::vector<Target> targets;
  int repetitions = 1;            ///< of all targets, each time in another order
  double hold_s = 1.0;            ///< without a break in both hands and inside the tolerance
  double time_limit_s = 30.0;     ///< of each carry
  double drop_distance_m = 0.02;  ///< let go further than this from where it began: dropped
  double lead_in_s = 3.0;         ///< both hands relaxed
  double rest_s = 3.0;            ///< between carries, likewise
  double fetch_s = 2.0;           ///< from a drop until it may be taken again

  [[nodiscard]] int carries() const noexcept {
    return repetitions * static_cast<int>(targets.size());
  }

  static const KindFacts kFacts;
};

/// Its measures (bimanual_pick_place_score.cpp).
[[nodiscard]] std::vector<Measure> score_bimanual_pick_place(const BimanualPickPlaceSpec& spec,
                                                             const Record& record);

}  // namespace isograsp::tasks
