// SPDX-License-Identifier: GPL-3.0-or-later
// A tray is lifted by two hands that press against its ends, and held level at a height. SI units,
// radians.
#pragma once

#include <string>
#include <vector>

#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct BimanualLiftSpec {
  std::string scene;       ///< of two hands, coupling "force"
  double level = 0.2;      ///< asked of each hand at the target, of the maximum of the weaker one
  double height_m = 0.08;  ///< of the target above its rest
  double position_tolerance_m = 0.015;               ///< of the height
  double angle_tolerance_rad = 0.17453292519943295;  ///< of the tilt: 10 degrees
  int lifts = 4;
  double hold_s = 2.0;         ///< without a break inside both tolerances: lifted
  double time_limit_s = 20.0;  ///< of each
  double lead_in_s = 4.0;      ///< both hands relaxed
  double rest_s = 6.0;         ///< between lifts, likewise
  double fetch_s = 2.0;        ///< from a drop until it may be lifted again

  static const KindFacts kFacts;
};

/// Its measures (bimanual_lift_score.cpp).
[[nodiscard]] std::vector<Measure> score_bimanual_lift(const BimanualLiftSpec& spec,
                                                       const Record& record);

}  // namespace isograsp::tasks
