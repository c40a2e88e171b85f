// SPDX-License-Identifier: GPL-3.0-or-later
// How much precision is reached how fast. Distances in any one unit, force or position.
#pragma once

#include "statistics/samples.hpp"

namespace isograsp::tasks {

/// Index of difficulty, version 1 [bit]: log2(distance / width + 1), the Shannon form (MacKenzie
/// 1992), with width = 2 tolerance.
[[nodiscard]] statistics::Computed index_of_difficulty(double distance, double tolerance);

/// One movement to a target.
struct AimedTrial {
  double distance = 0.0;  ///< from the start to the end of the movement, along the way asked for
  double error = 0.0;     ///< end minus centre of the target along that way, signed
  double time_s = 0.0;    ///< movement time
};
/// Effective width, version 1, unit of distance: 4.133 SD (n - 1) of the end points; 96 % of
/// normally distributed ends lie in it. No value for fewer than ten trials.
[[nodiscard]] statistics::Computed effective_width(std::span<const AimedTrial> trials);
/// Throughput, version 1 [bit/s]: log2(mean distance / effective width + 1) / mean time, of trials
/// of one distance and tolerance. Time-outs have no movement time and do not belong here: read the
/// proportion that reached the target first.
[[nodiscard]] statistics::Computed throughput(std::span<const AimedTrial> trials);

}  // namespace isograsp::tasks
