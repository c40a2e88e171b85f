// SPDX-License-Identifier: GPL-3.0-or-later
// Force tracking: the grip follows a sine between two fractions of the session's maximum.
//   T(t) = least + (most - least) (1 - cos(2 pi f t)) / 2      [N], t from the end of the lead-in
// The sine starts at its least value, where the lead-in holds it: no jump, in value or in slope.
#include <numbers>

#include "tasks/kinds/make_task.hpp"

namespace isograsp {

namespace {

class ForceTracking final : public Task {
 public:
  ForceTracking(const ForceTrackingSpec& spec, const TaskContext& context)
      : period_s_(context.period_s),
        least_N_(spec.least_fraction * context.maximum_force_N),
        range_N_((spec.most_fraction - spec.least_fraction) * context.maximum_force_N),
        omega_radps_(2.0 * std::numbers::pi * spec.frequency_Hz),
        lead_in_frames_(frames_in(spec.lead_in_s, context.period_s)),
        frames_(lead_in_frames_ + frames_in(spec.duration_s, context.period_s)) {}

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    view.phase = frame_ < lead_in_frames_ ? Phase::lead_in
                 : frame_ < frames_       ? Phase::active
                                          : Phase::done;
    const bool over = view.phase == Phase::done;
    view.cue = over ? Cue::relax : Cue::follow;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.force_target_shown = !over;
    const auto sine_frame = std::max<std::int64_t>(0, frame_ - lead_in_frames_);
    const double angle_rad = omega_radps_ * static_cast<double>(sine_frame) * period_s_;
    view.target_force_N = least_N_ + range_N_ * 0.5 * (1.0 - std::cos(angle_rad));
    view.actual_force_N = grip_force(input.wrench_C);
    if (!over) ++frame_;
    return view;
  }

 private:
  double period_s_;
  double least_N_;
  double range_N_;
  double omega_radps_;
  std::int64_t lead_in_frames_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_force_tracking(const ForceTrackingSpec& spec,
                                          const TaskContext& context) {
  return std::make_unique<ForceTracking>(spec, context);
}

}  // namespace isograsp
