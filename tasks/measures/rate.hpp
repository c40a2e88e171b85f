// SPDX-License-Identifier: GPL-3.0-or-later
// How fast a force changes. Rates come from zero-phase second-order Butterworth low-passed force
// (5 Hz per pass) by central differences, one-sided at the ends.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// dx/dt, unit of x per s. None if there are fewer than three samples or 10 Hz of them or less.
[[nodiscard]] std::optional<statistics::UniformSamples> rate_of_change(
    const statistics::UniformSamples& x);

/// Rate of force development, version 1 [N/s]: largest dF/dt.
[[nodiscard]] statistics::Computed peak_rate(std::span<const double> t_s,
                                             std::span<const double> force_N);
/// Fastest relaxation, version 1 [N/s]: largest -dF/dt.
[[nodiscard]] statistics::Computed peak_relaxation(std::span<const double> t_s,
                                                   std::span<const double> force_N);

/// Early rate of force development, version 1 [N/s]: (F(onset + 0.2 s) - F(onset)) / 0.2 s of the
/// force as recorded, the later value interpolated linearly. @pre onset < t_s.size()
[[nodiscard]] statistics::Computed early_rate(std::span<const double> t_s,
                                              std::span<const double> force_N, std::size_t onset);

/// Pauses on a ramp, version 1: stretches of at least 0.15 s with |dF/dt| < 40 % of the ramp's
/// rate. (Naik et al. 2011)
struct Pauses {
  statistics::Computed count;
  statistics::Computed mean_length_s;
};
/// @pre ramp_N_per_s is not zero; its sign does not matter
[[nodiscard]] Pauses pauses(std::span<const double> t_s, std::span<const double> force_N,
                            double ramp_N_per_s);

}  // namespace isograsp::tasks
