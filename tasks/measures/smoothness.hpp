// SPDX-License-Identifier: GPL-3.0-or-later
// How smooth a movement, or the change of a force, is. Uniform grids only; see on_uniform_grid().
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Speed [unit of position / s] from positions on a uniform grid: central differences, one-sided at
/// the ends. @pre axes have equal length of at least two
[[nodiscard]] statistics::UniformSamples speed_of(std::span<const statistics::UniformSamples> axes);

/// |dF/dt| [unit of force / s] likewise: the speed of a force, for sparc() and ldlj(). The sign is
/// left away as in a speed, so that letting go counts like gripping.
[[nodiscard]] statistics::UniformSamples rate_of(const statistics::UniformSamples& force);

/// Spectral arc length, version 1, dimensionless; closer to 0 is smoother. Spectrum of the speed
/// padded to 2^(ceil(log2 N) + 4), up to 10 Hz, between the first and last line of at least 0.05 of
/// the largest; frequency scaled to 0 … 1 over that range. (Balasubramanian et al. 2015)
/// @pre speed is never negative, so that line 0 is the largest
[[nodiscard]] statistics::Computed sparc(const statistics::UniformSamples& speed);

/// Log dimensionless jerk, version 1; closer to 0 is smoother:
/// -ln(T^3 / v_max^2 sum(second difference of speed / dt^2)^2 dt), T = N dt.
[[nodiscard]] statistics::Computed ldlj(const statistics::UniformSamples& speed);

}  // namespace isograsp::tasks
