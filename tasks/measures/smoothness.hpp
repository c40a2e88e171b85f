// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of smoothness and regularity. Uniform grids only; see on_uniform_grid().
#pragma once

#include <complex>

#include "tasks/measures/samples.hpp"

namespace isograsp {

/// Discrete Fourier transform in place, X_k = sum_n x_n exp(-2 pi i k n / N).
/// @pre the size is a power of two
void fourier_transform(std::span<std::complex<double>> x);

/// Speed [unit of position / s] from positions on a uniform grid: central differences, one-sided at
/// the ends. @pre axes have equal length of at least two
[[nodiscard]] UniformSamples speed_of(std::span<const UniformSamples> axes);

/// Spectral arc length, version 1, dimensionless; closer to 0 is smoother. Spectrum of the speed
/// padded to 2^(ceil(log2 N) + 4), up to 10 Hz, between the first and last line of at least 0.05 of
/// the largest; frequency scaled to 0 … 1 over that range. (Balasubramanian et al. 2015)
[[nodiscard]] Computed sparc(const UniformSamples& speed);

/// Log dimensionless jerk, version 1; closer to 0 is smoother:
/// -ln(T^3 / v_max^2 sum(second difference of speed / dt^2)^2 dt), T = N dt.
[[nodiscard]] Computed ldlj(const UniformSamples& speed);

/// Pairs of templates (i < j) that match: length m (B) and m + 1 (A).
struct TemplateMatches {
  std::int64_t longer = 0;   ///< A
  std::int64_t shorter = 0;  ///< B
};
/// m = 2, r = 0.2 population SD, Chebyshev distance <= r, N - m templates for both lengths.
[[nodiscard]] TemplateMatches template_matches(std::span<const double> x);
/// Sample entropy, version 1, dimensionless: -ln(A / B). Not detrended; lower is more regular.
[[nodiscard]] Computed sample_entropy(std::span<const double> x);

}  // namespace isograsp
