// SPDX-License-Identifier: GPL-3.0-or-later
// Pose targets: the object is brought to each pose in turn and held inside its tolerance.
// A target is reached when the object has stayed inside for hold_s without leaving; after the time
// limit the task goes on to the next target, and the measures treat that one as censored.
#include <vector>

#include "tasks/kinds/make_task.hpp"

namespace isograsp::tasks {

namespace {

class PoseTargets final : public Task {
 public:
  PoseTargets(const PoseTargetsSpec& spec, const TaskContext& context)
      : blank_(blank_view(context.references, {})),
        period_s_(context.period_s),
        tolerance_{spec.position_tolerance_m, spec.angle_tolerance_rad},
        limit_frames_(frames_in(spec.time_limit_s, context.period_s)) {
    goals_.reserve(spec.targets.size());
    for (const PoseTarget& target : spec.targets)
      goals_.push_back({Pose{target.p_WT, Quat(Eigen::AngleAxisd(target.angle_rad, Vec3::UnitZ()))},
                        frames_in(target.hold_s, context.period_s)});
  }

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view = blank_;
    view.duration_s =
        static_cast<double>(limit_frames_) * static_cast<double>(goals_.size()) * period_s_;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.actual_force_N = force_of(input.wrench_C, view.channel);
    view.target_count = static_cast<int>(goals_.size());
    view.targets_reached = reached_;
    if (current_ == goals_.size()) {
      view.phase = Phase::done;
      view.cue = Cue::relax;
      return view;
    }
    const Goal& goal = goals_[current_];
    const bool inside = input.object != nullptr && tolerance_.holds(goal.X_WT, input.object->pose);
    inside_frames_ = inside ? inside_frames_ + 1 : 0;
    const bool reached = inside_frames_ > goal.hold_frames;  // n + 1 samples span n periods
    if (reached) ++reached_;
    view.phase = inside ? Phase::hold : Phase::transport;
    view.cue = Cue::move;
    view.pose_target_shown = true;
    view.target = goal.X_WT;
    view.target_index = static_cast<int>(current_);
    view.targets_reached = reached_;
    view.hold_fraction = hold_fraction(goal, reached);
    ++frame_;
    ++target_frames_;
    if (reached || target_frames_ >= limit_frames_) {
      ++current_;
      target_frames_ = 0;
      inside_frames_ = 0;
    }
    return view;
  }

 private:
  struct Goal {
    Pose X_WT;
    std::int64_t hold_frames = 0;
  };

  [[nodiscard]] double hold_fraction(const Goal& goal, bool reached) const noexcept {
    if (reached) return 1.0;
    if (inside_frames_ == 0) return 0.0;
    return static_cast<double>(inside_frames_ - 1) / static_cast<double>(goal.hold_frames);
  }

  TaskView blank_;
  double period_s_;
  PoseTolerance tolerance_;
  std::int64_t limit_frames_;
  std::vector<Goal> goals_;
  std::size_t current_ = 0;
  std::int64_t frame_ = 0;
  std::int64_t target_frames_ = 0;  ///< since this target appeared
  std::int64_t inside_frames_ = 0;  ///< uninterrupted
  int reached_ = 0;
};

}  // namespace

std::unique_ptr<Task> make_pose_targets(const PoseTargetsSpec& spec, const TaskContext& context) {
  return std::make_unique<PoseTargets>(spec, context);
}

}  // namespace isograsp::tasks
