// SPDX-License-Identifier: GPL-3.0-or-later
// An object that two hands lift between them by what they press (coupling "force"): what that asks
// of each hand, and the same object made heavier or lighter. SI units, world axes, y up.
#pragma once

#include <cmath>

#include "bimanual/read_hands.hpp"
#include "core/result.hpp"

namespace isograsp::bimanual {

/// Of each of two hands that share the load equally and squeeze kSqueezeMargin times as much as
/// friction needs.
struct LiftDemand {
  double squeeze_N = 0.0;  ///< across
  double raise_N = 0.0;    ///< up
  [[nodiscard]] double force_N() const noexcept { return std::hypot(squeeze_N, raise_N); }
};
/// People squeeze about half as much again as an object needs (Johansson, Westling 1984).
inline constexpr double kSqueezeMargin = 1.5;

/// At rest `height_m` above where the object begins. Refused with field and remedy: hands that do
/// not face each other across, or press with single fingers; an object that cannot get there, or
/// weighs nothing.
[[nodiscard]] Result<LiftDemand> lift_demand(const HandsScene& scene, double height_m);

/// Masses, springs, dampers and thresholds times `factor` > 0: with forces times `factor` it moves
/// as it did.
[[nodiscard]] HandsScene strengthened(HandsScene scene, double factor);

}  // namespace isograsp::bimanual
