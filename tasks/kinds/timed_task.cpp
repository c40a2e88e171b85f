// SPDX-License-Identifier: GPL-3.0-or-later
// Tasks without a target: an instruction for a fixed time, perhaps after a relaxed lead-in. Rest,
// one attempt at the maximum, and free handling of an object.
#include "tasks/kinds/make_task.hpp"

namespace isograsp {

namespace {

class TimedTask final : public Task {
 public:
  TimedTask(double period_s, double lead_in_s, double active_s, Cue cue)
      : period_s_(period_s),
        lead_in_frames_(frames_in(lead_in_s, period_s)),
        frames_(lead_in_frames_ + frames_in(active_s, period_s)),
        cue_(cue) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    view.phase = frame_ < lead_in_frames_ ? Phase::lead_in
                 : frame_ < frames_       ? Phase::active
                                          : Phase::done;
    view.cue = view.phase == Phase::active ? cue_ : Cue::relax;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.actual_force_N = grip_force(input.wrench_C);
    if (frame_ < frames_) ++frame_;
    return view;
  }

 private:
  double period_s_;
  std::int64_t lead_in_frames_;
  std::int64_t frames_;
  Cue cue_;
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_rest(const RestSpec& spec, const TaskContext& context) {
  return std::make_unique<TimedTask>(context.period_s, 0.0, spec.duration_s, Cue::relax);
}

std::unique_ptr<Task> make_maximum(const MaximumSpec& spec, const TaskContext& context) {
  return std::make_unique<TimedTask>(context.period_s, spec.lead_in_s, spec.squeeze_s,
                                     Cue::squeeze);
}

std::unique_ptr<Task> make_observe(const ObserveSpec& spec, const TaskContext& context) {
  return std::make_unique<TimedTask>(context.period_s, 0.0, spec.duration_s, Cue::move);
}

}  // namespace isograsp
