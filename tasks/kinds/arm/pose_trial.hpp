// SPDX-License-Identifier: GPL-3.0-or-later
// A recorded trial of pose matching, target by target: the automaton of the task
// (kinematics/pose_task.hpp) run once more over its rows, and the movements between cue and entry.
// Measures, reports and drawings are made of it. SI units, radians.
#pragma once

#include <optional>
#include <vector>

#include "core/signals.hpp"
#include "kinematics/movement.hpp"
#include "kinematics/pose_task.hpp"
#include "tasks/kinds/arm/pose_matching.hpp"

namespace isograsp::tasks {

/// A target that was sought when the record ended: neither reached nor given up.
struct UnendedTarget {
  std::size_t target = 0;
  double sought_s = 0.0;  ///< on the task's clock
};

struct PoseTrial {
  /// Forearm in the elbow's frame, hand in the forearm's, object in the hand's, object in the
  /// world; brace and elbow stand in its [score] if they were recorded.
  Rig rig;
  PoseSeries series;              ///< the segments in the rows that the task saw: no pauses
  std::vector<PoseEvent> events;  ///< a target each, in their order
  std::optional<UnendedTarget> unended;
  MovementScores movements;  ///< one for each event
  Text unmeasured;           ///< why there are no movements; empty: there are
  /// Share of the time from the cue to the end of each target in which the object was not seen,
  /// pauses out of sight included; one for each event.
  std::vector<double> unseen;
};

/// Puts `more` behind `all` as if it had followed a second later: movements of several trials to be
/// looked at together. `unended` is that of `more`. False, and nothing is done: other segments were
/// recorded.
[[nodiscard]] bool append(PoseTrial& all, PoseTrial more);

/// Without events where the signals lack object, reference or targets.
[[nodiscard]] PoseTrial pose_trial(const PoseMatchingSpec& spec, const Signals& signals);

}  // namespace isograsp::tasks
