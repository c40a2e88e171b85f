// SPDX-License-Identifier: GPL-3.0-or-later
// When a finger counts as touching, for hands of any strength: above the noise of the sensor, but
// never so high that a weak hand cannot reach it.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "grasp_model/scene.hpp"
#include "hand/finger.hpp"
#include "tasks/references.hpp"

namespace isograsp::session {

/// max(5 noise SD, min(0.8 N, 5 % of the maximum)) [N] (docs/measures.md, "Touching").
/// @pre noise_sd_N >= 0, maximum_force_N > 0
[[nodiscard]] constexpr double contact_threshold_N(double noise_sd_N,
                                                   double maximum_force_N) noexcept {
  constexpr double kNoiseFactor = 5.0;
  constexpr double kMost_N = 0.8;
  constexpr double kShareOfMaximum = 0.05;
  return std::max(kNoiseFactor * noise_sd_N, std::min(kMost_N, kShareOfMaximum * maximum_force_N));
}

/// Thresholds of a session: of each finger by the noise of its normal force when the device was
/// empty, and by the maximum of the grip. Nothing as long as one of them is not measured: then a
/// scene's own ones count.
[[nodiscard]] std::array<std::optional<double>, kFingerCount> contact_thresholds(
    const tasks::ForceReferences& references);

/// The scene with these thresholds in place of its own.
[[nodiscard]] Scene with_thresholds(
    Scene scene, const std::array<std::optional<double>, kFingerCount>& threshold_N);
/// The thresholds that a scene has.
[[nodiscard]] std::array<std::optional<double>, kFingerCount> thresholds_of(const Scene& scene);

}  // namespace isograsp::session
