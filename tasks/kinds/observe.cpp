// SPDX-License-Identifier: GPL-3.0-or-later
// Free handling of an object: an instruction for a fixed time.
#include "tasks/kinds/make_task.hpp"

namespace isograsp::tasks {

namespace {

class Observe final : public Task {
 public:
  Observe(const ObserveSpec& spec, const TaskContext& context)
      : blank_(blank_view(context.references, {})),
        period_s_(context.period_s),
        frames_(frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view = blank_;
    view.phase = frame_ < frames_ ? Phase::active : Phase::done;
    view.cue = frame_ < frames_ ? Cue::move : Cue::relax;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.actual_force_N = force_of(input.wrench_C, view.channel);
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  TaskView blank_;
  double period_s_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_observe(const ObserveSpec& spec, const TaskContext& context) {
  return std::make_unique<Observe>(spec, context);
}

}  // namespace isograsp::tasks
