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

/// Spectral arc length, version 1 (spectral_arc_length(), kinematics/measures/smoothness.hpp).
/// @pre speed is never negative
[[nodiscard]] statistics::Computed sparc(const statistics::UniformSamples& speed);

/// Log dimensionless jerk, version 1 (log_dimensionless_jerk()).
[[nodiscard]] statistics::Computed ldlj(const statistics::UniformSamples& speed);

}  // namespace isograsp::tasks
