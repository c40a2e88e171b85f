// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients of axes that move independently, side by side for the processor (plan_lanes.cpp).
// Inside grasp_model/ only; plan.hpp includes it because a Plan holds one.
#pragma once

#include <array>
#include <cstddef>

#include "hand/finger.hpp"

namespace isograsp {

class Plan;
struct ObjectState;

/// Numbers in fours: first a finger a lane (kFingerOfLane), then a free axis a
/// lane: the translations in their order, behind them the one free rotation.
struct alignas(32) PlanLanes {
  using Four = double __attribute__((vector_size(32)));
  using Mask = long long __attribute__((vector_size(32)));

  /// Between them a square and its root keep all their digits.
  static constexpr double kLeast = 1e-280;
  static constexpr double kMost = 1e280;
  /// Three fingers in four lanes, so that few of them have to cross: thumb, middle, index, middle.
  static constexpr std::array<std::size_t, 4> kFingerOfLane{0, 2, 1, 2};

  // Fingers.
  Four friction{};
  /// f_z above which a finger touches; stays if it touched; touches and has a friction limit that
  /// can be squared [N].
  Four touches_above{}, stays_above{}, presses_above{};
  std::array<Mask, 8> passes{};                  ///< whose force acts, by the set that touches
  std::array<std::array<Four, 3>, 6> columns{};  ///< of f_x f_y f_z, by row of the grasp map
  // Axes: LinearStep.
  Four weight{};  ///< [N]
  Four anchor{};  ///< [m]
  Four force_share{}, position_share{}, x_of_v{}, x_of_off{}, v_of_v{}, v_of_off{};
  Mask about_rest{};
  bool some_about_rest = false;  ///< else force_share is 1
  /// The kernel of this plan, on this processor and on one without registers of this width; null
  /// if the plan needs more than independent axes.
  using Step = void(const Plan&, const FingerWrenches&, ObjectState&) noexcept;
  Step* step = nullptr;
  Step* narrow = nullptr;
};

}  // namespace isograsp
