// SPDX-License-Identifier: GPL-3.0-or-later
// Pose targets: the object is brought to each pose in turn and held inside its tolerance.
// A target is reached when the object has stayed inside for hold_s without leaving; after the time
// limit the task goes on to the next target, and the measures treat that one as censored.
#include "tasks/kinds/object/pose_targets.hpp"

#include <vector>

#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/pace.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class PoseTargets final : public Task {
 public:
  PoseTargets(const PoseTargetsSpec& spec, const TaskContext& context)
      : blank_(blank_force(context.references, {})),
        period_s_(context.period_s),
        tolerance_{spec.position_tolerance_m, spec.angle_tolerance_rad},
        limit_frames_(frames_in(spec.time_limit_s, context.period_s)) {
    goals_.reserve(spec.targets.size());
    for (const PoseTarget& target : spec.targets)
      goals_.push_back({Pose{target.p_WT, Quat(Eigen::AngleAxisd(target.angle_rad, Vec3::UnitZ()))},
                        frames_in(target.hold_s, context.period_s)});
  }

  TaskView step(const TaskInput& input) noexcept override {
    TaskView view;
    auto& object = view.special.emplace<ObjectView>();
    object.grip = with_force(blank_, input);
    view.duration_s =
        static_cast<double>(limit_frames_) * static_cast<double>(goals_.size()) * period_s_;
    view.task_time_s = static_cast<double>(frame_) * period_s_;
    view.target_count = static_cast<int>(goals_.size());
    view.targets_reached = reached_;
    if (current_ == goals_.size()) {
      view.phase = Phase::done;
      view.cue = Cue::relax;
      return view;
    }
    const Goal& goal = goals_[current_];
    const ObjectState* const state = object_of(input).object;
    const bool inside = state != nullptr && tolerance_.holds(goal.X_WT, state->X_WO);
    inside_frames_ = inside ? inside_frames_ + 1 : 0;
    const bool reached = inside_frames_ > goal.hold_frames;  // n + 1 samples span n periods
    if (reached) ++reached_;
    view.phase = inside ? Phase::hold : Phase::transport;
    view.cue = Cue::move;
    object.pose_target_shown = true;
    object.X_WT = goal.X_WT;
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

  ForceView blank_;
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

Result<std::unique_ptr<Task>> make_pose_targets(const PoseTargetsSpec& spec,
                                                const TaskContext& context) {
  return std::unique_ptr<Task>(std::make_unique<PoseTargets>(spec, context));
}

KindSpec read_pose_targets(TomlReader& reader) {
  PoseTargetsSpec spec;
  spec.scene = read_scene(reader);
  const PoseTolerance tolerance =
      read_tolerance(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerance.position_m;
  spec.angle_tolerance_rad = tolerance.angle_rad;
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  for (TomlReader& table : reader.tables("target")) {
    PoseTarget target;
    target.p_WT = table.vec3("position_m");
    target.angle_rad =
        kRadPerDeg * read_within(table, "angle_deg", -kMostAngle_deg, kMostAngle_deg, 0.0);
    target.hold_s = read_wait(table, "hold_s", 0.0);
    target.level = table.boolean("level", false);
    if (target.hold_s >= spec.time_limit_s)
      table.fail("hold_s", "leaves no time within time_limit_s"_text, "make it shorter"_text);
    spec.targets.push_back(target);
  }
  if (spec.targets.empty())
    reader.fail("target", "is missing"_text, "add at least one [[target]]"_text);
  return spec;
}

Duration pose_targets_duration(const PoseTargetsSpec& spec) {
  return duration_of_targets(spec.time_limit_s, spec.targets.size());
}

std::vector<TargetPlace> pose_targets_places(const PoseTargetsSpec& spec) {
  std::vector<TargetPlace> places;
  for (const PoseTarget& target : spec.targets)
    places.push_back({std::nullopt, target.p_WT, target.angle_rad, target.hold_s > 0.0});
  return places;
}

PoseTolerance pose_targets_tolerance(const PoseTargetsSpec& spec) {
  return {spec.position_tolerance_m, spec.angle_tolerance_rad};
}

int pose_targets_count(const PoseTargetsSpec& spec) {
  return static_cast<int>(spec.targets.size());
}

constexpr PlacedMeasure kPoseTargetsPlaces[] = {{"targets_reached", "", Prominence::key},
                                                {"tilt_in_transport", "", Prominence::key},
                                                {"path_efficiency", "", Prominence::trend}};

}  // namespace

constinit const KindFacts PoseTargetsSpec::kFacts{.name = "pose_targets",
                                                  .group = TaskGroup::object,
                                                  .read = read_pose_targets,
                                                  .duration = of_kind<pose_targets_duration>,
                                                  .scene = own_scene<PoseTargetsSpec>,
                                                  .targets = of_kind<pose_targets_places>,
                                                  .tolerance = of_kind<pose_targets_tolerance>,
                                                  .multiply = multiply<PoseTargetsSpec>,
                                                  .wardrobe = Wardrobe::object,
                                                  .repetitions = of_kind<pose_targets_count>,
                                                  .make = of_kind<make_pose_targets>,
                                                  .measures = of_kind<score_pose_targets>,
                                                  .places = kPoseTargetsPlaces,
                                                  .path_drawn = true};

}  // namespace isograsp::tasks
