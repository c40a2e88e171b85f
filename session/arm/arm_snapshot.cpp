// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_snapshot.hpp"

#include <utility>
#include <variant>

#include "kinematics/pose_series.hpp"

namespace isograsp::session {

ArmSetup setup_of(const ArmRig& rig, std::vector<std::string> markers) {
  ArmSetup setup;
  setup.rig = rig.rig.name;
  setup.view = rig.rig.view.value_or(RigView{});
  setup.markers = std::move(markers);
  for (std::size_t s = 0; s < kArmSegmentCount; ++s)
    setup.has_segment[s] = rig.frame_of[s].has_value();
  const auto object = rig.frame_of[index_of(ArmSegment::object)];
  if (!object) return setup;  // markers alone
  if (const auto* cluster = std::get_if<ClusterFrame>(&rig.rig.frames[*object].method))
    setup.object_m = cluster->template_m;
  return setup;
}

bool outlasts_a_stand_in(double unseen_s) noexcept {
  return unseen_s > kLongestStandIn_s + kMarkerTimeSlack_s;
}

namespace {

ObjectSight sight_of(const ArmSnapshot& now) noexcept {
  if (has_pose(now.segment(ArmSegment::object).state)) return ObjectSight::seen;
  if (is_missing(now.last_X_WO)) return ObjectSight::unknown;
  return outlasts_a_stand_in(now.unseen_s) ? ObjectSight::unseen : ObjectSight::held;
}

}  // namespace

Stimulus screen_of(const ArmSnapshot& now) noexcept {
  Stimulus screen;
  screen.t_s = now.session_time_s;
  screen.force_shown = false;
  screen.cue = screen.page_cue = Cue::relax;
  if (now.stage != Stage::trial && now.stage != Stage::paused) return screen;
  screen.page_cue = now.task.cue;
  screen.cue = now.stage == Stage::paused ? Cue::relax : screen.page_cue;
  screen.progress = {now.task.phase == tasks::Phase::lead_in,
                     now.task.phase == tasks::Phase::hold,
                     now.task.task_time_s,
                     now.task.duration_s,
                     now.task.segment,
                     now.task.target_index,
                     now.task.target_count,
                     now.task.targets_reached,
                     now.task.hold_fraction};
  screen.object_shown = has_pose(now.segment(ArmSegment::object).state);
  screen.sight = sight_of(now);
  if (screen.sight != ObjectSight::unknown) screen.X_WO = now.last_X_WO;
  screen.angle = now.angle;
  const tasks::ArmView& task = now.special.arm();
  screen.pose_target_shown = task.reference_shown;
  screen.X_WT = task.reference_shown ? task.X_WR : screen.X_WO;
  screen.turn = task.turn;
  screen.pose_matched = task.matched;
  return screen;
}

}  // namespace isograsp::session
