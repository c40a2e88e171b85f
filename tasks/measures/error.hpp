// SPDX-License-Identifier: GPL-3.0-or-later
// How far the actual signal is from its target, how steady it is, how high it gets.
// error e = actual - target; weights w are hold lengths [s]. All spans have the same length.
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// sum(w x) / sum(w), unit of x.
[[nodiscard]] statistics::Computed weighted_mean(std::span<const double> x,
                                                 std::span<const double> weight);

/// Root mean square error, version 1: sqrt(sum(w e^2) / sum(w)).
[[nodiscard]] statistics::Computed rmse(std::span<const double> target,
                                        std::span<const double> actual,
                                        std::span<const double> weight);
/// Mean absolute error, version 1: sum(w |e|) / sum(w).
[[nodiscard]] statistics::Computed mae(std::span<const double> target,
                                       std::span<const double> actual,
                                       std::span<const double> weight);
/// Constant error, version 1: sum(w e) / sum(w); positive: above the target.
[[nodiscard]] statistics::Computed constant_error(std::span<const double> target,
                                                  std::span<const double> actual,
                                                  std::span<const double> weight);
/// Relative error, version 1, in %: 100 rmse / largest |target| (Kurillo family).
[[nodiscard]] statistics::Computed relative_rmse(std::span<const double> target,
                                                 std::span<const double> actual,
                                                 std::span<const double> weight);
/// Time in range, version 1, in %: share of time with |e| <= max(0.05 |target|, 3 noise_sd).
[[nodiscard]] statistics::Computed time_in_range(std::span<const double> target,
                                                 std::span<const double> actual,
                                                 std::span<const double> weight,
                                                 double noise_sd = 0.0);

/// The same for a band of choice, version 1: |e| <= max(share_of_target |target|, 3 noise_sd).
[[nodiscard]] statistics::Computed time_in_band(std::span<const double> target,
                                                std::span<const double> actual,
                                                std::span<const double> weight,
                                                double share_of_target, double noise_sd);

/// Staying between two bounds, version 1. Distance d = lower - actual below, actual - upper above,
/// 0 inside; both means run over the whole time, also that inside.
struct Corridor {
  statistics::Computed time_inside_percent;  ///< share of time with d = 0
  statistics::Computed mean_outside;         ///< sum(w d) / sum(w), unit of actual
  statistics::Computed rms_outside;          ///< sqrt(sum(w d^2) / sum(w))
};
[[nodiscard]] Corridor corridor(std::span<const double> lower, std::span<const double> upper,
                                std::span<const double> actual, std::span<const double> weight);

/// Coefficient of variation, version 1, in %: 100 SD(n-1) of x after removing its least-squares
/// line over t, divided by the mean of x.
[[nodiscard]] statistics::Computed cv(std::span<const double> t_s, std::span<const double> x);

/// Largest mean of x over any window of `window_s` of uninterrupted samples, version 1, unit of x.
/// `valid[k]`: sample k may be used. The last sample of a window counts only as far as it reaches
/// in.
[[nodiscard]] statistics::Computed best_moving_mean(std::span<const double> x,
                                                    std::span<const double> weight,
                                                    const std::vector<bool>& valid,
                                                    double window_s);

}  // namespace isograsp::tasks
