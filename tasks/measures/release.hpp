// SPDX-License-Identifier: GPL-3.0-or-later
// How soon and how completely a grip opens when "let go" is cued.
#pragma once

#include <optional>
#include <span>

#include "statistics/samples.hpp"
#include "tasks/measures/onset.hpp"

namespace isograsp::tasks {

/// What was asked before the cue, and what the hand and the sensors do by themselves.
struct AskedGrip {
  double asked_N = 0.0;       ///< the force to be held
  double resting_N = 0.0;     ///< of the relaxed hand
  double noise_sd_N = 0.0;    ///< of the empty device; 0: not known
  double resolution_N = 0.0;  ///< 0: not known

  /// How much a force must be above rest to be the grip asked for: half of what was asked, and more
  /// than max(3 noise SD, 2 x resolution).
  [[nodiscard]] double least_N() const;
};

/// Letting go at a cue, version 2. The force held is that of the second before the cue: a grip was
/// made if its mean is at least AskedGrip::least_N() above rest. Where none was made there is
/// nothing to let go, so that nothing else has a value.
struct Release {
  std::optional<bool> grip_made;    ///< nothing: fewer than two rows before the cue, or none after
  Reaction initiation;              ///< below mean held - max(3 SD held, 2 LSB) for 50 ms
  statistics::EventTime release;    ///< from the cue to resting + 10 % of (peak held - resting) or
                                    ///< less for 50 ms, interpolated linearly
  statistics::Computed residual_N;  ///< mean from 4.9 to 5.1 s after the cue, above resting
  statistics::Computed fastest_N_per_s;  ///< largest -dF/dt after the cue (rate.hpp)
};
/// @pre t_s.size() == force_N.size()
[[nodiscard]] Release release(std::span<const double> t_s, std::span<const double> force_N,
                              double cue_s, const AskedGrip& grip);

}  // namespace isograsp::tasks
