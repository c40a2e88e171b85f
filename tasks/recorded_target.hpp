// SPDX-License-Identifier: GPL-3.0-or-later
// A target recorded by doing: the therapist guides the hand once, and what was done becomes the
// target of a task file.
#pragma once

#include <string>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

struct RecordedTarget {
  std::string name;     ///< of the task
  bool force = false;   ///< the force, also where an object was moved
  double slower = 1.0;  ///< stretches the time
};

/// The text of a task whose target is what `signals`, a trial of `spec`, did: the path of the
/// object in every degree of freedom that moved (pose_tracking), or the force of the task's channel
/// in newtons (force_tracking). Freed of tremor (zero-phase, -6 dB at 2 Hz), ten points a second;
/// stillness before and after is cut to half a second. Refused where hardly anything moved, or
/// where the object turned about more than one axis.
[[nodiscard]] Result<std::string> target_by_doing(const TaskSpec& spec, const Signals& signals,
                                                  const RecordedTarget& wanted);

}  // namespace isograsp::tasks
