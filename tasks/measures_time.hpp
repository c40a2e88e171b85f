// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of time: how much later, how much smaller, how fast the answer to a target is.
#pragma once

#include "tasks/measures.hpp"

namespace isograsp {

/// Lag by cross-correlation [s], version 1; positive when `actual` follows `target`. Pearson r over
/// the overlapping samples, re-centred at each whole shift within +-1.5 s; parabola through the
/// peak. No value if r < 0.35 everywhere, or if the peak lies at the limit.
/// @pre both on the same uniform grid
[[nodiscard]] Computed lag(const UniformSamples& target, const UniformSamples& actual);

/// Least-squares x = offset + amplitude sin(omega t + phase).
struct SineFit {
  double offset = 0.0;
  double amplitude = 0.0;
  double phase_rad = 0.0;
};
[[nodiscard]] std::optional<SineFit> fit_sine(std::span<const double> t_s,
                                              std::span<const double> x, double frequency_Hz);
/// Gain, version 1, dimensionless: amplitude of actual / amplitude of target, both fitted at the
/// target's frequency. Needs at least one whole cycle.
[[nodiscard]] Computed gain(std::span<const double> t_s, std::span<const double> target,
                            std::span<const double> actual, double frequency_Hz);

/// Answer to a step from 0 to a nominal final value, version 1. Levels are first upward crossings,
/// interpolated linearly.
struct StepResponse {
  std::optional<double> t10_s;  ///< 10 % of the final value
  std::optional<double> t63_s;  ///< 1 - 1/e
  std::optional<double> t90_s;
  std::optional<double> rise10_90_s;   ///< t90 - t10
  double overshoot = 0.0;              ///< (largest - final) / final, at least 0
  std::optional<double> settle2pct_s;  ///< first time after which |y - final| <= 2 % of it
};
/// @pre t_s.size() == y.size(), not empty, final_value != 0
[[nodiscard]] StepResponse step_response(std::span<const double> t_s, std::span<const double> y,
                                         double final_value);

}  // namespace isograsp
