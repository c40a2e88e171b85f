// SPDX-License-Identifier: GPL-3.0-or-later
// A force task as a list of segments, each with one instruction and perhaps a target: everything
// that can be known before the trial begins is computed then. Playing it costs a look-up per frame.
#pragma once

#include <memory>
#include <vector>

#include "core/result.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

struct Segment {
  Phase phase = Phase::active;
  Cue cue = Cue::relax;
  ForceChannel channel;
  bool force_shown = true;
  bool target_shown = true;  ///< if there is one
  std::int64_t frames = 0;
  std::vector<double> target_N;  ///< one per frame, or one for all; empty: there is none
  DigitTargets digits;
};

using Segments = std::vector<Segment>;

struct Timeline {
  Segments segments;
  [[nodiscard]] std::int64_t frames() const noexcept;
};

/// The segments of a force task. Refused, with the field at fault and a remedy: a reference that
/// was not measured, effort that the screening does not allow, a target above the ceiling, a band
/// below what the sensors resolve. @pre spec is a force task
[[nodiscard]] Result<Timeline> timeline_of(const TaskSpec& spec, const TaskContext& context);

/// The task that goes through it.
[[nodiscard]] std::unique_ptr<Task> play(Timeline timeline, const TaskContext& context);

}  // namespace isograsp::tasks
