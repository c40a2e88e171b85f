// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual object is grasped by the virtual hand that follows the tracked one, brought to its
// target, held there and let go (docs/virtual_hand.md, "Placements"). SI units, radians.
#pragma once

#include <vector>

#include "tasks/kind_spec.hpp"
#include "virtual_hand/assistance_level.hpp"
#include "virtual_hand/placement.hpp"

namespace isograsp::tasks {

struct VirtualPickPlaceSpec {
  struct Item {
    std::size_t object = 0;  ///< of virtual_hand::study_objects()
    std::size_t target = 0;  ///< of virtual_hand::targets_of() its size
  };
  virtual_hand::AssistanceLevel assistance = virtual_hand::AssistanceLevel::off;
  /// Training: after three fails the next placements are easier.
  bool eases = false;
  double position_tolerance_m = 0.01;
  double angle_tolerance_rad = 0.2617993877991494;  ///< 15 degrees, of the main axes
  double table_m = 0.1;  ///< height of the table on the screen above the origin of the tracker
  std::vector<Item> items;

  static constexpr double kTimeLimit_s = 60.0;     ///< of a placement
  static constexpr double kReleaseLimit_s = 10.0;  ///< then the object lets go by itself
  static constexpr int kMostFails = 3;             ///< then it is eased, where that is allowed
  /// So long no digit touches an object that was let go: a touch that flickers is none that ended.
  static constexpr double kFree_s = 0.1;

  [[nodiscard]] virtual_hand::PlacementRule rule() const noexcept;
  static const KindFacts kFacts;
};

/// Its measures (virtual_pick_place_score.cpp).
[[nodiscard]] std::vector<Measure> score_virtual_pick_place(const VirtualPickPlaceSpec& spec,
                                                            const Record& record);

}  // namespace isograsp::tasks
