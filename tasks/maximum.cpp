// SPDX-License-Identifier: GPL-3.0-or-later
// Maximum: relaxed lead-in, then build up, squeeze, stop. One attempt.
#include "tasks/task_kinds.hpp"

namespace isograsp {

namespace {

class Maximum final : public Task {
 public:
  Maximum(const MaximumSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
        lead_in_frames_(frames_in(spec.lead_in_s, context.period_s)),
        frames_(lead_in_frames_ + frames_in(spec.squeeze_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    view.phase = frame_ < lead_in_frames_ ? Phase::lead_in
                 : frame_ < frames_       ? Phase::active
                                          : Phase::done;
    view.cue = view.phase == Phase::active ? Cue::squeeze : Cue::relax;
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
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_maximum(const MaximumSpec& spec, const TaskContext& context) {
  return std::make_unique<Maximum>(spec, context);
}

}  // namespace isograsp
