// SPDX-License-Identifier: GPL-3.0-or-later
// Sines by least squares: amplitude and phase of the answer beside those of the target.
#pragma once

#include <optional>
#include <span>

#include "tasks/measures/samples.hpp"

namespace isograsp {

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

}  // namespace isograsp
