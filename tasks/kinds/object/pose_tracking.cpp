// SPDX-License-Identifier: GPL-3.0-or-later
// Pose tracking: the target moves, or jumps, in some degrees of freedom; the object is kept on it.
#include "tasks/kinds/object/pose_tracking.hpp"

#include <vector>

#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/kinds/tools/read_waveform.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"
#include "tasks/waveform.hpp"

namespace isograsp::tasks {

namespace {

class PoseTracking final : public Task {
 public:
  PoseTracking(const PoseTrackingSpec& spec, const TaskContext& context)
      : blank_(blank_force(context.references, {})),
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
    TaskView view;
    auto& object = view.special.emplace<ObjectView>();
    object.grip = with_force(blank_, input);
    const bool over = frame_ >= frames_;
    view.phase = over ? Phase::done : frame_ < lead_in_frames_ ? Phase::lead_in : Phase::active;
    view.cue = over ? Cue::relax : Cue::move;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.duration_s = static_cast<double>(frames_) * period_s_;
    if (over) return view;
    object.pose_target_shown = true;
    object.X_WT = pose_of(
        targets_[static_cast<std::size_t>(std::max<std::int64_t>(0, frame_ - lead_in_frames_))]);
    ++frame_;
    return view;
  }

 private:
  /// One rotation is free at most, so the order of turns does not matter.
  static Pose pose_of(const Vec6& x) noexcept {
    const Vec3 turn = x.tail<3>();
    const double angle_rad = turn.norm();
    Pose X_WT{x.head<3>(), Quat::Identity()};
    if (angle_rad > 0.0) X_WT.q = Quat(Eigen::AngleAxisd(angle_rad, turn / angle_rad));
    return X_WT;
  }

  ForceView blank_;
  double period_s_;
  std::int64_t lead_in_frames_;
  std::int64_t frames_;
  std::int64_t frame_ = 0;
  std::vector<Vec6> targets_;  ///< x y z [m], rx ry rz [rad], one per frame of the target
};

Result<std::unique_ptr<Task>> make_pose_tracking(const PoseTrackingSpec& spec,
                                                 const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<PoseTracking>(spec, context));
}

KindSpec read_pose_tracking(TomlReader& reader) {
  PoseTrackingSpec spec;
  spec.scene = read_scene(reader);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  spec.duration_s = read_duration(reader, "duration_s", spec.duration_s);
  std::array<bool, 6> used{};
  for (TomlReader& table : reader.tables("axis")) {
    constexpr double kMost_m = 1.0;
    PoseTrackingSpec::Axis axis;
    axis.axis = static_cast<int>(table.choice("dof", {"x", "y", "z", "rx", "ry", "rz"}));
    const bool turns = axis.axis >= 3;
    const double most = turns ? kMostAngle_deg : kMost_m;
    const double unit = turns ? kRadPerDeg : 1.0;
    axis.least = unit * read_within(table, turns ? "least_deg" : "least_m", -most, most);
    axis.most = unit * read_within(table, turns ? "most_deg" : "most_m", -most, most);
    axis.waveform = read_waveform(table, spec.duration_s);
    if (axis.waveform.shape == Waveform::Shape::csv && axis.waveform.values.empty())
      table.fail("waveform", "cannot be a file here"_text,
                 "write its points into [axis.csv_data], or choose another shape"_text);
    if (std::exchange(used[static_cast<std::size_t>(axis.axis)], true))
      table.fail("dof", "is driven twice"_text, "write one [[axis]] per degree of freedom"_text);
    spec.axes.push_back(std::move(axis));
  }
  if (spec.axes.empty()) reader.fail("axis", "is missing"_text, "add at least one [[axis]]"_text);
  if (used[3] + used[4] + used[5] > 1)
    reader.fail("axis", "turns about more than one axis"_text,
                "let the target turn about rx, ry or rz alone"_text);
  return spec;
}

Duration pose_tracking_duration(const PoseTrackingSpec& spec) {
  return {spec.lead_in_s + spec.duration_s, spec.lead_in_s + spec.duration_s};
}

std::optional<AxisCourse> pose_tracking_course(const PoseTrackingSpec& spec, double period_s) {
  if (spec.axes.empty()) return std::nullopt;
  const auto& axis = spec.axes.front();
  const auto value = [&](double sample) { return axis.least + sample * (axis.most - axis.least); };
  const auto samples = samples_of(axis.waveform, spec.duration_s, period_s, 0);
  const auto lead_in = static_cast<std::size_t>(spec.lead_in_s / period_s);
  AxisCourse course{axis.axis, {}};
  if (!samples.empty()) course.values.assign(lead_in, value(samples.front()));
  for (const double sample : samples) course.values.push_back(value(sample));
  return course;
}

// The whole distance and angle stand for the single degrees of freedom.
constexpr PlacedMeasure kPoseTrackingPlaces[] = {{"rmse", "position", Prominence::key},
                                                 {"rmse", "attitude", Prominence::key},
                                                 {"lag", "", Prominence::trend}};

}  // namespace

constinit const KindFacts PoseTrackingSpec::kFacts{.name = "pose_tracking",
                                                   .group = TaskGroup::object,
                                                   .read = read_pose_tracking,
                                                   .duration = of_kind<pose_tracking_duration>,
                                                   .scene = own_scene<PoseTrackingSpec>,
                                                   .course = of_kind<pose_tracking_course>,
                                                   .make = of_kind<make_pose_tracking>,
                                                   .measures = of_kind<score_pose_tracking>,
                                                   .places = kPoseTrackingPlaces};

}  // namespace isograsp::tasks
