// SPDX-License-Identifier: GPL-3.0-or-later
// Inside tasks/ only: a task of two hands as a list of segments, each with what either hand is to
// do and perhaps what is asked of it, or of both together. All is computed before the trial begins;
// playing it costs a look-up per frame. "Force of a hand" is its grip force, as measured.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/result.hpp"
#include "hand/hands.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

struct HandsSegment {
  Phase phase = Phase::active;
  OfHands<Cue> cue{Cue::relax, Cue::relax};
  std::int64_t frames = 0;
  // Asked for [N]: one per frame, or one for all; empty: nothing is.
  std::vector<double> sum_N;            ///< of both together
  OfHands<std::vector<double>> each_N;  ///< of each
  // On the screen.
  bool sum_shown = false;    ///< the force of both together
  OfHands<bool> each_shown;  ///< that of each
};

/// Both hands are to be relaxed.
[[nodiscard]] HandsSegment hands_relaxed(std::int64_t frames, Phase phase);

struct HandsTimeline {
  std::vector<HandsSegment> segments;
  double band_fraction = 0.0;  ///< of the target: half of what counts as on it; 0: there is no band
  const char* level_key = "";  ///< in its file: names the field of a target that is refused
  bool rests = false;          ///< no effort is asked for, whatever the screening says
};

/// What a task asks of one hand at most.
struct AskedOfHand {
  double force_N = 0.0;
  std::optional<double> band_N = std::nullopt;  ///< to either side; nothing: there is none
};
/// In its file: the fields that are named by what is refused.
struct AskedKeys {
  const char* level = "";
  const char* band = "";
};

// Clinical rules of all that is asked of two hands (docs/bimanual.md), each with a remedy.
/// Refuses where the screening allows no effort at all.
[[nodiscard]] Result<void> check_any_effort(Effort allowed);
/// Refuses where the maximum of a hand is not known.
[[nodiscard]] Result<void> check_maxima(const OfHands<HandReferences>& of);
/// Refuses more than half of the maximum of a hand, more than its ceiling, and a band that its
/// sensors cannot resolve. @pre check_maxima(of)
[[nodiscard]] Result<void> check_asked(const OfHands<AskedOfHand>& asked,
                                       const OfHands<HandReferences>& of, const AskedKeys& keys);

/// The task that goes through it. Refused, with a remedy: effort that the screening does not allow;
/// a target where the maximum of a hand is not known; one that asks either hand for more than half
/// of its maximum, a sum shared by what they can do, or for more than its ceiling; a band that the
/// sensors cannot resolve (clinical rules: docs/bimanual.md). @pre there is a segment with frames
[[nodiscard]] Result<std::unique_ptr<Task>> play_hands(HandsTimeline timeline,
                                                       const TaskContext& context);

}  // namespace isograsp::tasks
