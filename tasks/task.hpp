// SPDX-License-Identifier: GPL-3.0-or-later
// A task in progress: a state machine stepped once per frame. No I/O, no clock, no thread; step()
// is real-time safe (make_task() allocates all it needs).
#pragma once

#include <limits>
#include <memory>

#include "core/result.hpp"
#include "grasp_model/plan.hpp"
#include "hand/finger.hpp"
#include "hand/stimulus.hpp"
#include "tasks/references.hpp"
#include "tasks/task_spec.hpp"

namespace isograsp::tasks {

/// What a task may depend on besides its file; stored with the trial.
struct TaskContext {
  double period_s = 0.01;  ///< of the frame grid
  std::uint64_t seed = 0;  ///< of fresh sequences and waits that cannot be foreseen
  ForceReferences references;
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
  FingerWrenches wrench_C;                   ///< zeroed, contact frames
  const ObjectState* object = nullptr;       ///< null: a force task
  std::array<bool, kFingerCount> contact{};  ///< fingers that touch the object
};

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// What the screen shows and the record keeps after a step.
struct TaskView {
  Phase phase = Phase::lead_in;
  Cue cue = Cue::relax;
  double task_time_s = 0.0;  ///< stands still while paused
  double duration_s = 0.0;   ///< expected end of the task, for the progress bar
  int segment = 0;           ///< which part of a force task, from 0
  ForceChannel channel;      ///< the force that the task is about
  bool force_shown = true;   ///< the patient sees the own force
  bool has_force_target = false;
  bool force_target_shown = false;  ///< … and the patient sees it
  double target_force_N = 0.0;
  double actual_force_N = 0.0;  ///< of the channel
  DigitTargets digit_targets;
  double resting_force_N = kNotMeasured;  ///< of the channel
  double maximum_force_N = kNotMeasured;
  double noise_sd_N = 0.0;
  bool pose_target_shown = false;
  Pose X_WT;
  int target_index = -1;  ///< which of target_count
  int target_count = 0;
  int targets_reached = 0;
  int drops = 0;
  bool object_placed = false;  ///< the object appears anew, at rest, after this frame, at
  Pose placed_X_WO;
  double hold_fraction = 0.0;  ///< 0 … 1: progress ring
};

/// What a view has before the first step: the references of a force.
[[nodiscard]] TaskView blank_view(const ForceReferences& references, ForceChannel channel);

class Task {
 public:
  virtual ~Task() = default;
  /// One frame of task time. The view's phase becomes `done` at the end and stays so.
  [[nodiscard]] virtual TaskView step(const TaskInput& input) noexcept = 0;
};

/// Refuses a task whose context is incomplete (a sine in % of a maximum that was not measured).
[[nodiscard]] Result<std::unique_ptr<Task>> make_task(const TaskSpec& spec,
                                                      const TaskContext& context);

}  // namespace isograsp::tasks
