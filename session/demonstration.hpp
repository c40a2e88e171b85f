// SPDX-License-Identifier: GPL-3.0-or-later
// How a task is done, for the patient to watch: a healthy simulated person does it through the same
// closed loop as a trial. Nothing is stored.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "session/platform/snapshot.hpp"
#include "tasks/task.hpp"

namespace isograsp::session {

struct Demonstration {
  std::shared_ptr<const tasks::TaskSpec> task;
  tasks::TaskContext context;          ///< the task was made with
  std::shared_ptr<const Scene> scene;  ///< as the hand met it; null: a force task
  double period_s = 0.0;               ///< between frames
  std::vector<Snapshot> frames;        ///< from the beginning of the trial on
};

/// Longest part that is shown [s]; tasks repeat themselves.
inline constexpr double kLongestDemonstration_s = 30.0;

/// `references`: of the patient who watches, so that targets look like their own; what was not
/// measured yet is assumed. What the screening or the sensors would refuse is shown nevertheless.
/// Takes a fraction of a second. Any thread.
[[nodiscard]] Result<Demonstration> demonstrate(const tasks::TaskSpec& spec,
                                                const tasks::ForceReferences& references, Hand hand,
                                                const std::string& library);

}  // namespace isograsp::session
