// SPDX-License-Identifier: GPL-3.0-or-later
// Observe: the object may be handled freely for a fixed time; there is no target.
#include "tasks/task_kinds.hpp"

namespace isograsp {

namespace {

class Observe final : public Task {
 public:
  Observe(const ObserveSpec& spec, const TaskContext& context)
      : period_s_(context.period_s), frames_(frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    const bool over = frame_ >= frames_;
    view.phase = over ? Phase::done : Phase::active;
    view.cue = over ? Cue::relax : Cue::move;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.actual_force_N = grip_force(input.wrench_C);
    if (!over) ++frame_;
    return view;
  }

 private:
  double period_s_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_observe(const ObserveSpec& spec, const TaskContext& context) {
  return std::make_unique<Observe>(spec, context);
}

}  // namespace isograsp
