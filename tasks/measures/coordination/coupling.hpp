// SPDX-License-Identifier: GPL-3.0-or-later
// How grip force follows load, and how much grip is more than needed. Load and friction are those
// of the virtual object: never to be compared with free lifting.
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Grip force [N], version 1: mean of the opposing normal forces, (thumb + fingers) / 2. It follows
/// load more closely than their minimum. (Prebeg et al. 2014)
/// @param fingers_N  sum of the fingers that oppose the thumb
[[nodiscard]] std::vector<double> opposing_mean(std::span<const double> thumb_N,
                                                std::span<const double> fingers_N);

/// Grip-load coupling, version 1.
struct Coupling {
  statistics::Computed correlation =
      "not computed"_text;                           ///< largest Pearson r over lags within +-0.5 s
  statistics::Computed lag_s = "not computed"_text;  ///< where it is; positive: grip follows load
  statistics::Computed slope =
      "not computed"_text;  ///< least squares, grip on load without lag [N / N]
};
/// Correlations are of the samples that overlap, re-centred at each lag; the lag is refined by a
/// parabola and has no value if the peak lies at the limit.
/// @pre both on the same uniform grid
[[nodiscard]] Coupling grip_load_coupling(const statistics::UniformSamples& grip,
                                          const statistics::UniformSamples& load);

/// Safety margin, version 1, in % of the grip: weighted mean of 100 (G - G_needed) / G over samples
/// with G > 0. G_needed [N] is the grip at which friction just carries the load, |L| / mu; with G =
/// opposing_mean(), L is half of the load of the object. Negative: it slips.
[[nodiscard]] statistics::Computed safety_margin(std::span<const double> grip_N,
                                                 std::span<const double> needed_N,
                                                 std::span<const double> weight);

/// Pearson correlation, version 1, weighted. No value where one of the two does not vary.
[[nodiscard]] statistics::Computed correlation(std::span<const double> x, std::span<const double> y,
                                               std::span<const double> weight);

/// Variation, version 1, in %: 100 SD / mean, both weighted, SD of the population.
[[nodiscard]] statistics::Computed variation(std::span<const double> x,
                                             std::span<const double> weight);

}  // namespace isograsp::tasks
