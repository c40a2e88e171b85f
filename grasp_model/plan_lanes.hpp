// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients of axes that move independently, side by side for the processor (plan_lanes.cpp).
// Inside grasp_model/ only; plan.hpp includes it because a Plan holds one.
#pragma once

#include <array>

#include "hand/finger.hpp"

namespace isograsp {

class Plan;
struct ObjectState;

/// A lane is one free axis: up to three translations, then the rotation or, for the forces alone,
/// three. Two lanes stand in one vector register.
struct PlanLanes {
  using Pair = double __attribute__((vector_size(16)));
  using Four = std::array<Pair, 2>;
  using Six = std::array<Pair, 3>;

  Four weight{};  ///< [N]
  Four anchor{};  ///< [m]
  Four force_share{}, position_share{}, x_of_v{}, x_of_off{}, v_of_v{}, v_of_off{};
  Four about_rest{};                                       ///< 0 or 1
  std::array<std::array<Six, 3>, kFingerCount> columns{};  ///< of f_x f_y f_z, by contact
  /// The kernel of this plan; null if it needs more than independent axes.
  void (*step)(const Plan&, const FingerWrenches&, ObjectState&) noexcept = nullptr;

  template <std::size_t pairs>
  static void put(std::array<Pair, pairs>& lanes, std::size_t lane, double value) {
    lanes[lane / 2][lane % 2] = value;
  }
};

}  // namespace isograsp
