// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/arm/pose_matching.hpp"

#include <algorithm>
#include <utility>

#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"
#include "tasks/task.hpp"

namespace isograsp::tasks {

namespace {

class PoseMatching final : public Task {
 public:
  PoseMatching(const PoseMatchingSpec& spec, PoseTask task)
      : task_(std::move(task)), run_(task_), duration_s_(duration_s(spec)) {}

  TaskView step(const TaskInput& input) noexcept override {
    const auto* const arm = std::get_if<ArmInput>(&input);
    const ArmInput seen = arm != nullptr ? *arm : ArmInput{};
    if (const auto event = run_.step(seen.t_s, seen.X_WO); event && event->enter_s) ++reached_;
    TaskView view;
    view.duration_s = duration_s_;
    view.target_count = static_cast<int>(task_.targets.size());
    view.task_time_s = run_.clock_s(seen.t_s);
    view.targets_reached = reached_ + (run_.matched() ? 1 : 0);
    auto& shown = view.special.emplace<ArmView>();
    if (run_.finished()) {
      view.phase = Phase::done;
      view.cue = Cue::relax;
      return view;
    }
    if (!run_.started()) {
      view.cue = Cue::relax;
      return view;  // lead-in until the object is seen for the first time
    }
    view.cue = Cue::move;
    view.target_index = static_cast<int>(run_.target());
    view.phase = run_.matched() ? Phase::active : run_.inside() ? Phase::hold : Phase::transport;
    shown.reference_shown = true;
    shown.X_WR = task_.references[task_.targets[run_.target()]].X_WR;
    shown.matched = run_.matched();
    view.hold_fraction = run_.hold_fraction(seen.t_s);
    return view;
  }

  /// As a rule a target takes half the time allowed.
  static Duration duration(const PoseMatchingSpec& spec) {
    const auto count = static_cast<double>(spec.targets());
    Duration duration = duration_of_targets(spec.time_limit_s, spec.targets());
    duration.nominal_s += spec.display_s * count;
    duration.worst_s += (spec.display_s + spec.hold_s) * count;
    return duration;
  }

 private:
  static double duration_s(const PoseMatchingSpec& spec) { return duration(spec).nominal_s; }

  PoseTask task_;
  PoseTaskRun run_;  ///< refers to task_
  double duration_s_;
  int reached_ = 0;
};

Result<std::unique_ptr<Task>> make_pose_matching(const PoseMatchingSpec& spec,
                                                 const TaskContext& context) {
  auto task = pose_task_of(spec, context.references_of_poses);
  if (!task) return task.error();
  return std::unique_ptr<Task>(std::make_unique<PoseMatching>(spec, *std::move(task)));
}

KindSpec read_pose_matching(TomlReader& reader) {
  constexpr int kMostRepeats = 100;
  constexpr double kPercent = 100.0;
  constexpr double kLeastWay_percent = 10.0;
  PoseMatchingSpec spec;
  spec.postures = reader.text("postures");
  spec.sequence = reader.texts("sequence");
  if (spec.sequence.empty())
    reader.fail("sequence", "names no posture"_text, "name the postures in their order"_text);
  spec.repeats = read_count(reader, "repeats", spec.repeats, kMostRepeats);
  spec.way = read_within(reader, "way_percent", kLeastWay_percent, kPercent, kPercent) / kPercent;
  spec.scale =
      reader.choice("scale", {"none", "length"}, 0) == 0 ? SizeScale::none : SizeScale::length;
  const PoseTolerance tolerance =
      read_tolerance(reader, {spec.position_tolerance_m, spec.angle_tolerance_rad});
  spec.position_tolerance_m = tolerance.position_m;
  spec.angle_tolerance_rad = tolerance.angle_rad;
  spec.hold_s = read_wait(reader, "hold_s", spec.hold_s);
  spec.display_s = read_wait(reader, "display_s", spec.display_s);
  spec.time_limit_s = read_duration(reader, "time_limit_s", spec.time_limit_s);
  if (spec.hold_s >= spec.time_limit_s)
    reader.fail("hold_s", "leaves no time within time_limit_s"_text, "make it shorter"_text);
  return spec;
}

Duration pose_matching_duration(const PoseMatchingSpec& spec) {
  return PoseMatching::duration(spec);
}

PoseTolerance pose_matching_tolerance(const PoseMatchingSpec& spec) {
  return {spec.position_tolerance_m, spec.angle_tolerance_rad};
}

int pose_matching_count(const PoseMatchingSpec& spec) {
  return static_cast<int>(spec.targets());
}

std::string pose_matching_postures(const PoseMatchingSpec& spec) {
  return spec.postures;
}

constexpr PlacedMeasure kPoseMatchingPlaces[] = {{"targets_reached", "", Prominence::key},
                                                 {"movement_time", "", Prominence::key},
                                                 {"position_error", "", Prominence::trend},
                                                 {"angle_error", "", Prominence::trend}};

}  // namespace

Result<PoseTask> pose_task_of(const PoseMatchingSpec& spec,
                              const std::vector<PoseReference>& references) {
  PoseTask task;
  task.references = references;
  task.position_tolerance_m = spec.position_tolerance_m;
  task.angle_tolerance_rad = spec.angle_tolerance_rad;
  task.hold_s = spec.hold_s;
  task.display_s = spec.display_s;
  task.time_limit_s = spec.time_limit_s;
  for (int repeat = 0; repeat < spec.repeats; ++repeat)
    for (const std::string& name : spec.sequence) {
      const auto at =
          std::find_if(references.begin(), references.end(),
                       [&name](const PoseReference& reference) { return reference.name == name; });
      if (at == references.end())
        return refused("'%1' is no posture of %2"_text(name, Known{spec.postures}),
                       "name a [[posture]] of that file"_text)
            .about("sequence");
      task.targets.push_back(static_cast<std::size_t>(at - references.begin()));
    }
  return task;
}

constinit const KindFacts PoseMatchingSpec::kFacts{.name = "pose_matching",
                                                   .group = TaskGroup::arm,
                                                   .read = read_pose_matching,
                                                   .apparatus = "arm",
                                                   .duration = of_kind<pose_matching_duration>,
                                                   .postures = of_kind<pose_matching_postures>,
                                                   .tolerance = of_kind<pose_matching_tolerance>,
                                                   .multiply = multiply<PoseMatchingSpec>,
                                                   .repetitions = of_kind<pose_matching_count>,
                                                   .make = of_kind<make_pose_matching>,
                                                   .measures = of_kind<score_pose_matching>,
                                                   .places = kPoseMatchingPlaces};

}  // namespace isograsp::tasks
