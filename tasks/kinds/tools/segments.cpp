// SPDX-License-Identifier: GPL-3.0-or-later
// A ramp of n frames: target_k = from + (k / n) (to - from), k = 0 ... n - 1.
#include "tasks/kinds/tools/segments.hpp"

namespace isograsp::tasks {

Segment relaxed(ForceChannel channel, double duration_s, const Pace& pace, Phase phase) {
  Segment segment;
  segment.phase = phase;
  segment.cue = Cue::relax;
  segment.channel = channel;
  segment.frames = pace.frames(duration_s);
  return segment;
}

Segment effort(ForceChannel channel, Cue cue, double duration_s, const Pace& pace) {
  Segment segment;
  segment.cue = cue;
  segment.channel = channel;
  segment.frames = pace.frames(duration_s);
  return segment;
}

Segment on_level(const Aim& aim, double level_N, double duration_s, Phase phase, const Pace& pace) {
  Segment segment;
  segment.phase = phase;
  segment.cue = Cue::follow;
  segment.channel = aim.channel;
  segment.force_shown = aim.force_shown;
  segment.frames = pace.frames(duration_s);
  segment.target_N = {level_N};
  return segment;
}

Segment to_level(const Aim& aim, double from_N, double to_N, double duration_s, Phase phase,
                 const Pace& pace) {
  Segment segment = on_level(aim, to_N, duration_s, phase, pace);
  if (segment.frames == 0) return segment;
  segment.target_N.resize(static_cast<std::size_t>(segment.frames));
  for (std::size_t k = 0; k < segment.target_N.size(); ++k)
    segment.target_N[k] =
        std::lerp(from_N, to_N, static_cast<double>(k) / static_cast<double>(segment.frames));
  return segment;
}

}  // namespace isograsp::tasks
