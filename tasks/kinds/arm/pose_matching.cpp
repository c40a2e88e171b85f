// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kinds/arm/pose_matching.hpp"

#include <algorithm>
#include <utility>

#include "tasks/kinds/arm/read_posture_keys.hpp"
#include "tasks/kinds/tools/of_kind.hpp"
#include "tasks/kinds/tools/read_object_keys.hpp"

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
  auto task = pose_task_of(spec, context.arm);
  if (!task) return task.error();
  return std::unique_ptr<Task>(std::make_unique<PoseMatching>(spec, *std::move(task)));
}

KindSpec read_pose_matching(TomlReader& reader) {
  constexpr int kMostRepeats = 100;
  PoseMatchingSpec spec;
  if (reader.has("own_range"))
    spec.own_range = read_own_range(reader);
  else
    spec.postures = reader.text("postures");
  spec.sequence = read_sequence(reader);
  spec.repeats = read_count(reader, "repeats", spec.repeats, kMostRepeats);
  spec.way = read_way(reader);
  spec.scale = read_scale(reader);
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

Result<PoseTask> pose_task_of(const PoseMatchingSpec& spec, const std::optional<ArmPostures>& arm) {
  const auto once = places_of(spec.sequence, spec.own_range ? "own_range" : spec.postures, arm);
  if (!once) return once.error();
  const Postures library = part_of_the_way(arm->library, spec.way);
  PoseTask task;
  task.frame = library.chain.empty() ? "" : library.chain.back();
  for (std::size_t j = 0; j < library.postures.size(); ++j)
    task.references.push_back(
        {library.postures[j].name, adapted(library, j, arm->start, spec.scale)});
  task.position_tolerance_m = spec.position_tolerance_m;
  task.angle_tolerance_rad = spec.angle_tolerance_rad;
  task.hold_s = spec.hold_s;
  task.display_s = spec.display_s;
  task.time_limit_s = spec.time_limit_s;
  for (int repeat = 0; repeat < spec.repeats; ++repeat)
    task.targets.insert(task.targets.end(), once->begin(), once->end());
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
                                                   .wardrobe = Wardrobe::object,
                                                   .repetitions = of_kind<pose_matching_count>,
                                                   .make = of_kind<make_pose_matching>,
                                                   .measures = of_kind<score_pose_matching>,
                                                   .places = kPoseMatchingPlaces};

}  // namespace isograsp::tasks
