// SPDX-License-Identifier: GPL-3.0-or-later
// How a force that should be held fades.
#pragma once

#include <span>

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Fatigue slope, version 1 [%/s]: least-squares slope of the force over time, in % of its mean
/// (weighted by hold lengths) over the first 5 s. Negative: fading. Needs more than 5 s.
[[nodiscard]] statistics::Computed fatigue_slope(std::span<const double> t_s,
                                                 std::span<const double> force_N);

/// Endurance, version 1 [s]: from the first sample until the force stays below 80 % of that mean
/// for 1 s. Censored if it never does.
[[nodiscard]] statistics::EventTime time_to_fatigue(std::span<const double> t_s,
                                                    std::span<const double> force_N);

}  // namespace isograsp::tasks
