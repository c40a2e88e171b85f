// SPDX-License-Identifier: GPL-3.0-or-later
// Two hands that are points carry an object: how they do it, and what forces that takes of these
// hands.
//   force at the edge = max(edge_fraction M, kEdgeNoise sigma, kEdgeSteps step of the sensors)
//   force that holds  = max(kHoldsAt of it, kHoldNoise sigma)
#pragma once

#include <algorithm>

#include "tasks/references.hpp"

namespace isograsp::tasks {

/// What a task asks for of two hands that carry.
struct HandsCarry {
  bool clutch = false;          ///< a clutch moves the bubbles; else pressing beyond their edges
  bool pinch = false;           ///< magnetic pinch and joint control; else friction of pads
  double edge_fraction = 0.15;  ///< of the maximum of each hand: reaches the edge of its bubble
  double affected_share = 0.5;  ///< weight of the affected hand while bubbles move as one
};

/// Forces of one hand in a trial [N].
struct CarryForces {
  double at_edge_N = 0.0;  ///< reaches the edge of its bubble, along any axis
  double on_N = 0.0;       ///< squeezed by more it holds; by half of it no more
};

/// @pre of.maximum_N
[[nodiscard]] inline CarryForces carry_forces(const HandReferences& of, double edge_fraction) {
  constexpr double kEdgeNoise = 10.0;  // noise moves the point by a tenth of its bubble at most
  constexpr double kEdgeSteps = 20.0;
  constexpr double kHoldsAt = 0.25;
  constexpr double kHoldNoise = 5.0;
  const double noise_N = of.noise_sd_N.value_or(0.0);
  CarryForces forces;
  forces.at_edge_N = std::max({edge_fraction * *of.maximum_N, kEdgeNoise * noise_N,
                               kEdgeSteps * of.resolution_N.value_or(0.0)});
  forces.on_N = std::max(kHoldsAt * forces.at_edge_N, kHoldNoise * noise_N);
  return forces;
}

/// Carries that are asked of a patient in a session; more are a study of healthy volunteers.
inline constexpr int kMostCarries = 24;

}  // namespace isograsp::tasks
