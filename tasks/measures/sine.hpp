// SPDX-License-Identifier: GPL-3.0-or-later
// Sines by least squares: amplitude and phase of the answer beside those of the target.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

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
[[nodiscard]] statistics::Computed gain(std::span<const double> t_s, std::span<const double> target,
                                        std::span<const double> actual, double frequency_Hz);

/// Least-squares x = offset + sum of amplitude_i sin(2 pi frequency_i t + phase_i), all together.
struct SinesFit {
  double offset = 0.0;
  std::vector<SineFit> sines;  ///< in the order of the frequencies, their own offsets zero
  Text reason;                 ///< why there are none
};
/// Needs at least one whole cycle of the smallest frequency and of the smallest difference between
/// two: less cannot tell them apart.
[[nodiscard]] SinesFit fit_sines(std::span<const double> t_s, std::span<const double> x,
                                 std::span<const double> frequencies_Hz);

/// How one sine of the target is answered, version 1 but for the gain.
struct SineAnswer {
  double frequency_Hz = 0.0;
  statistics::Computed gain;       ///< amplitude of actual / amplitude of target
  statistics::Computed phase_rad;  ///< of actual - of target, in (-pi, pi]
  statistics::Computed
      lag_s;  ///< -phase / omega: positive when actual follows, known up to whole cycles
};
/// One per frequency, target and actual fitted jointly. @pre spans of samples have equal length
[[nodiscard]] std::vector<SineAnswer> sine_answers(std::span<const double> t_s,
                                                   std::span<const double> target,
                                                   std::span<const double> actual,
                                                   std::span<const double> frequencies_Hz);

}  // namespace isograsp::tasks
