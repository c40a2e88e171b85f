// SPDX-License-Identifier: GPL-3.0-or-later
// Pose tracking: the target moves, or jumps, in some degrees of freedom; the object is kept on it.
#include <vector>

#include "tasks/kinds/make_task.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

namespace {

class PoseTracking final : public Task {
 public:
  PoseTracking(const PoseTrackingSpec& spec, const TaskContext& context)
      : blank_(blank_view(context.references, {})),
        period_s_(context.period_s),
        lead_in_frames_(frames_in(spec.lead_in_s, context.period_s)),
        frames_(lead_in_frames_ + frames_in(spec.duration_s, context.period_s)) {
    targets_.resize(static_cast<std::size_t>(frames_ - lead_in_frames_), Vec6::Zero());
    for (const auto& axis : spec.axes) {
      // Axes with fresh sequences must not move alike.
      const auto seed = context.seed + static_cast<std::uint64_t>(axis.axis);
      const auto values = samples_of(axis.waveform, spec.duration_s, period_s_, seed);
      for (std::size_t k = 0; k < targets_.size(); ++k)
        targets_[k][axis.axis] = std::lerp(axis.least, axis.most, values[k]);
    }
  }

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view = blank_;
    const bool over = frame_ >= frames_;
    view.phase = over ? Phase::done : frame_ < lead_in_frames_ ? Phase::lead_in : Phase::active;
    view.cue = over ? Cue::relax : Cue::move;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    view.actual_force_N = force_of(input.wrench_C, view.channel);
    if (over) return view;
    view.pose_target_shown = true;
    view.target = pose_of(
        targets_[static_cast<std::size_t>(std::max<std::int64_t>(0, frame_ - lead_in_frames_))]);
    ++frame_;
    return view;
  }

 private:
  /// One rotation is free at most, so the order of turns does not matter.
  static Pose pose_of(const Vec6& x) noexcept {
    const Vec3 turn = x.tail<3>();
    const double angle_rad = turn.norm();
    Pose pose{x.head<3>(), Quat::Identity()};
    if (angle_rad > 0.0) pose.q_WO = Quat(Eigen::AngleAxisd(angle_rad, turn / angle_rad));
    return pose;
  }

  TaskView blank_;
  double period_s_;
  std::int64_t lead_in_frames_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
  std::vector<Vec6> targets_;  ///< x y z [m], rx ry rz [rad], one per frame of the target
};

}  // namespace

std::unique_ptr<Task> make_pose_tracking(const PoseTrackingSpec& spec, const TaskContext& context) {
  return std::make_unique<PoseTracking>(spec, context);
}

}  // namespace isograsp::tasks
