// SPDX-License-Identifier: GPL-3.0-or-later
// A task in progress: a state machine stepped once per frame. No I/O, no clock, no thread; step()
// is real-time safe (make_task() allocates all it needs).
#pragma once

#include <memory>

#include "core/finger.hpp"
#include "core/result.hpp"
#include "core/stimulus.hpp"
#include "grasp_model/plan.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp {

/// Grip force on a bolted device: the smaller of the thumb and the two opposing fingers together,
/// from the signed normal forces [N] (docs/measures.md).
[[nodiscard]] double grip_force(const FingerWrenches& wrench_C) noexcept;

/// What a task may depend on besides its file; stored with the trial.
struct TaskContext {
  double period_s = 0.01;        ///< of the frame grid
  double maximum_force_N = 0.0;  ///< of this session; 0: not measured
  double resting_force_N = 0.0;  ///< grip at rest in this session; NaN: not measured
  double noise_sd_N = 0.0;       ///< of the grip, device empty; 0: no instrument zero
  std::uint64_t seed = 0;
};

/// Stages of a trial as stored in the column `phase`.
enum class Phase : std::uint8_t {
  lead_in = 0,    ///< not scored
  active = 1,     ///< scored
  transport = 2,  ///< pose targets: on the way, level
  hold = 3,       ///< pose targets: inside the tolerance
  paused = 4,     ///< device fault or therapist: nothing counts
  done = 5
};
[[nodiscard]] std::string_view name_of(Phase phase) noexcept;

struct TaskInput {
  FingerWrenches wrench_C;              ///< zeroed, contact frames
  const ObjectState* object = nullptr;  ///< null: a force task
};

/// What the screen shows and the record keeps after a step.
struct TaskView {
  Phase phase = Phase::lead_in;
  Cue cue = Cue::relax;
  double task_time_s = 0.0;  ///< stands still while paused
  double duration_s = 0.0;   ///< expected end of the task, for the progress bar
  bool force_target_shown = false;
  double target_force_N = 0.0;
  double actual_force_N = 0.0;  ///< grip
  bool pose_target_shown = false;
  Pose target;
  int target_index = -1;  ///< which of target_count
  int target_count = 0;
  int targets_reached = 0;
  double hold_fraction = 0.0;  ///< 0 … 1: progress ring
};

class Task {
 public:
  virtual ~Task() = default;
  /// One frame of task time. The view's phase becomes `done` at the end and stays so.
  [[nodiscard]] virtual TaskView step(const TaskInput& input) noexcept = 0;
};

/// Refuses a task whose context is incomplete (a sine in % of a maximum that was not measured).
[[nodiscard]] Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec,
                                                      const TaskContext& context);

}  // namespace isograsp
