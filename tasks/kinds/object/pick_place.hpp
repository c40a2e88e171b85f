// SPDX-License-Identifier: GPL-3.0-or-later
// The object appears, is picked up, carried to its target, held there and let go. SI units,
// radians.
#pragma once

#include <string>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/kind_spec.hpp"

namespace isograsp::tasks {

struct PickPlaceSpec {
  struct Item {
    Vec3 p_WO = Vec3::Zero();  ///< where it appears [m]
    Vec3 p_WT = Vec3::Zero();  ///< where it is to be [m]
    double angle_rad = 0.0;    ///< of the target about world z
  };
  std::string scene;
  double position_tolerance_m = 0.02;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees
  double hold_s = 1.0;
  double time_limit_s = 30.0;     ///< per object
  double drop_distance_m = 0.02;  ///< further than this without a touch: dropped
  std::vector<Item> items;

  static const KindFacts kFacts;
};

/// Its measures (pick_place_score.cpp).
[[nodiscard]] std::vector<Measure> score_pick_place(const PickPlaceSpec& spec,
                                                    const Record& record);

}  // namespace isograsp::tasks
