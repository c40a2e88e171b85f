// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: what the segments of force tasks are made of.
#pragma once

#include "tasks/timeline.hpp"

namespace isograsp::tasks {

[[nodiscard]] Segment relaxed(ForceChannel channel, double duration_s, const Pace& pace,
                              Phase phase = Phase::lead_in);
[[nodiscard]] Segment effort(ForceChannel channel, Cue cue, double duration_s, const Pace& pace);
/// A target that stays at `level_N`.
[[nodiscard]] Segment on_level(const Aim& aim, double level_N, double duration_s, Phase phase,
                               const Pace& pace);
/// A straight target from one level to another; its end is the first value of what follows.
[[nodiscard]] Segment to_level(const Aim& aim, double from_N, double to_N, double duration_s,
                               Phase phase, const Pace& pace);

}  // namespace isograsp::tasks
