// SPDX-License-Identifier: GPL-3.0-or-later
// How soon and how completely a grip opens when "let go" is cued.
#pragma once

#include <span>

#include "tasks/measures/onset.hpp"
#include "tasks/measures/samples.hpp"

namespace isograsp {

/// Letting go at a cue, version 1. The force held is that of the second before the cue.
struct Release {
  Reaction initiation;  ///< below mean held - max(3 SD held, 2 LSB) for 50 ms
  EventTime release;    ///< from the cue to resting + 10 % of (peak held - resting) or less for
                        ///< 50 ms, interpolated linearly
  Computed residual_N;  ///< mean from 4.9 to 5.1 s after the cue, above resting
  Computed fastest_N_per_s;  ///< largest -dF/dt after the cue (rate.hpp)
};
/// `resting`: level of the relaxed hand. `lsb_N`: resolution of the force.
/// @pre t_s.size() == force_N.size()
[[nodiscard]] Release release(std::span<const double> t_s, std::span<const double> force_N,
                              double cue_s, const RestingLevel& resting, double lsb_N);

}  // namespace isograsp
