// SPDX-License-Identifier: GPL-3.0-or-later
// How smooth a movement is: formulas of a speed on a strict grid, which measures of hands use, too;
// and of the angular speed of each link of an arm and of the speed of the object, behind the
// low-pass of kinematics/measures/zero_phase.hpp. Times in s, speeds in m/s and rad/s. Sources:
// docs/measures.md.
#pragma once

#include <span>
#include <vector>

#include "core/result.hpp"
#include "kinematics/movement.hpp"

namespace isograsp {

/// Spectral arc length, dimensionless, closer to 0 is smoother. Spectrum of the speed padded to
/// 2^(ceil(log2 N) + 4), up to 10 Hz, between the first and last line of at least 0.05 of the
/// largest; frequency scaled to 0 … 1 over that range. (Balasubramanian et al. 2015)
/// @pre speed is never negative, so that line 0 is the largest
[[nodiscard]] Valued spectral_arc_length(std::span<const double> speed, double step_s);

/// Log dimensionless jerk, closer to 0 is smoother:
/// -ln(T^3 / v_max^2 sum(second difference of speed / dt^2)^2 dt), T = N dt.
[[nodiscard]] Valued log_dimensionless_jerk(std::span<const double> speed, double step_s);

/// Rows of the maxima of movement units: local maxima at least 20 mm/s above the local minimum
/// before them (the first row may be one) and at least 150 ms behind the one counted before. A
/// speed that still rises at the end has no maximum there; of a flat top the first row counts.
/// @pre no value is missing, times increase
[[nodiscard]] std::vector<std::size_t> movement_units(std::span<const double> t_s,
                                                      std::span<const double> speed);

/// sparc and ldlj, channel: the link; sparc, ldlj, movement_units and peak_speed, channel
/// "position": the object. No value where the rows from the cue to the match have a hole; sparc and
/// ldlj none of a movement within 5 degrees or 10 mm. Errors:
/// the rig has no [score], or a frame is not in the series.
[[nodiscard]] Result<std::vector<MovementMeasure>> movement_smoothness(
    const Rig& rig, const PoseSeries& series, std::span<const PoseTarget> targets);

}  // namespace isograsp
