// SPDX-License-Identifier: GPL-3.0-or-later
// How two hands that press at the same time divide a force: shares, effort, and whether one makes
// up for the other. "Affected" and "other" are the two hands; every force is one that a hand made.
#pragma once

#include <optional>
#include <span>

#include "core/spatial.hpp"
#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Shares from mean forces [N], version 1. A mean that is not above zero counts as zero.
struct HandShare {
  statistics::Computed affected_percent;   ///< 100 A / (A + U)
  statistics::Computed asymmetry_percent;  ///< 100 (U - A) / (A + U)
};
[[nodiscard]] HandShare hand_share(double affected_N, double other_N);

/// Share of effort, version 1, in %: 100 a / (a + u), a and u the means in parts of what each hand
/// can do. Who gives less force with the weaker hand may still work harder with it.
/// @pre both maxima are above zero
[[nodiscard]] statistics::Computed effort_share(double affected_N, double other_N,
                                                double maximum_affected_N, double maximum_other_N);

/// Synergy of two hands, version 1: 2 (V_U - V_O) / (V_U + V_O), variances of what is left of the
/// two forces along (1, -1), which leaves their sum alone, and along (1, 1). 2: each makes up for
/// the other; 0: independent; -2: both vary together. What follows the common target is taken out
/// first, by least squares on 1, t, T and dT/dt: hands that follow one target vary together however
/// well they make up for each other.
/// @param target  sum asked for; none: 1 and t alone
/// @pre all on the same uniform grid
[[nodiscard]] statistics::Computed hand_synergy(const statistics::UniformSamples& left_N,
                                                const statistics::UniformSamples& right_N,
                                                const statistics::UniformSamples* target_N);

/// Share of the pushes that the hands take from each other, version 1, in %:
/// 100 (1 - sum(w |F_L + F_R|) / sum(w (|F_L| + |F_R|))); none below 0.5 N of both on average.
[[nodiscard]] statistics::Computed cancelled_share(std::span<const Vec3> left_N,
                                                   std::span<const Vec3> right_N,
                                                   std::span<const double> weight);

}  // namespace isograsp::tasks
