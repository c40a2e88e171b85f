// SPDX-License-Identifier: GPL-3.0-or-later
// The reference moves on a clock that stands still while the object is out of sight.
#include "tasks/kinds/arm/pose_following.hpp"

#include <algorithm>
#include <utility>

#include "kinematics/reference_path.hpp"
#include "kinematics/sight_clock.hpp"
#include "tasks/kinds/arm/read_posture_keys.hpp"
#include "tasks/kinds/tools/of_kind.hpp"

namespace isograsp::tasks {

namespace {

class PoseFollowing final : public Task {
 public:
  PoseFollowing(const PoseFollowingSpec& spec, ReferencePath path)
      : path_(std::move(path)),
        lead_in_s_(spec.lead_in_s),
        whole_s_(spec.lead_in_s + spec.moving_s()),
        legs_(static_cast<int>(spec.sequence.size()) * spec.rounds) {}

  TaskView step(const TaskInput& input) noexcept override {
    const auto* const arm = std::get_if<ArmInput>(&input);
    const ArmInput now = arm != nullptr ? *arm : ArmInput{};
    clock_.step(now.t_s, !is_missing(now.X_WO));
    TaskView view;
    auto& shown = view.special.emplace<ArmView>();
    view.cue = Cue::relax;
    view.duration_s = whole_s_;
    view.task_time_s = std::min(clock_.elapsed_s(now.t_s), whole_s_);
    if (!clock_.started()) return view;  // until the object is seen for the first time
    const double moving_s = view.task_time_s - lead_in_s_;
    if (view.task_time_s >= whole_s_ - kMarkerTimeSlack_s) {
      view.phase = Phase::done;
      return view;
    }
    view.phase = moving_s < -kMarkerTimeSlack_s ? Phase::lead_in : Phase::active;
    view.cue = Cue::move;
    view.segment = std::min(path_.leg(moving_s), legs_ - 1);
    shown.reference_shown = true;
    shown.X_WR = path_.at(moving_s);
    return view;
  }

 private:
  ReferencePath path_;
  SightClock clock_;
  double lead_in_s_;
  double whole_s_;
  int legs_;
};

Result<std::unique_ptr<Task>> make_pose_following(const PoseFollowingSpec& spec,
                                                  const TaskContext& context) {
  const auto round = places_of(spec.sequence, spec.postures, context.arm);
  if (!round) return round.error();
  const Postures library = part_of_the_way(context.arm->library, spec.way);
  return std::unique_ptr<Task>(std::make_unique<PoseFollowing>(
      spec, ReferencePath(library, *round, context.arm->start, spec.scale, spec.leg_s)));
}

KindSpec read_pose_following(TomlReader& reader) {
  constexpr int kMostRounds = 100;
  constexpr double kLeastLeg_s = 0.5;  // faster, nobody could follow
  PoseFollowingSpec spec;
  spec.postures = reader.text("postures");
  spec.sequence = read_sequence(reader);
  if (spec.sequence.size() == 1)
    reader.fail("sequence", "names one posture only, so that nothing moves"_text,
                "name two postures or more"_text);
  spec.leg_s = read_within(reader, "leg_s", kLeastLeg_s, kLongestPart_s, spec.leg_s);
  spec.rounds = read_count(reader, "rounds", spec.rounds, kMostRounds);
  spec.way = read_way(reader);
  spec.scale = read_scale(reader);
  spec.lead_in_s = read_wait(reader, "lead_in_s", spec.lead_in_s);
  return spec;
}

Duration pose_following_duration(const PoseFollowingSpec& spec) {
  const double whole_s = spec.lead_in_s + spec.moving_s();
  return {whole_s, whole_s};
}

std::string pose_following_postures(const PoseFollowingSpec& spec) {
  return spec.postures;
}

constexpr PlacedMeasure kPoseFollowingPlaces[] = {{"rmse", "position", Prominence::key},
                                                  {"rmse", "attitude", Prominence::key},
                                                  {"lag", "attitude", Prominence::trend}};

}  // namespace

constinit const KindFacts PoseFollowingSpec::kFacts{.name = "pose_following",
                                                    .group = TaskGroup::arm,
                                                    .read = read_pose_following,
                                                    .apparatus = "arm",
                                                    .duration = of_kind<pose_following_duration>,
                                                    .postures = of_kind<pose_following_postures>,
                                                    .make = of_kind<make_pose_following>,
                                                    .measures = of_kind<score_pose_following>,
                                                    .places = kPoseFollowingPlaces};

}  // namespace isograsp::tasks
