// SPDX-License-Identifier: GPL-3.0-or-later
// Rest: hand in, relaxed, for a fixed time; every frame counts.
#include "tasks/task_kinds.hpp"

namespace isograsp {

namespace {

class Rest final : public Task {
 public:
  Rest(const RestSpec& spec, const TaskContext& context)
      : period_s_(context.period_s), frames_(frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    view.phase = frame_ < frames_ ? Phase::active : Phase::done;
    view.cue = Cue::relax;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.actual_force_N = grip_force(input.wrench_C);
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  double period_s_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_rest(const RestSpec& spec, const TaskContext& context) {
  return std::make_unique<Rest>(spec, context);
}

}  // namespace isograsp
