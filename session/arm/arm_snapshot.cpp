// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::session {

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
  const FramePose& object = now.segment(ArmSegment::object);
  screen.object_shown = has_pose(object.state);
  if (screen.object_shown) screen.X_WO = object.X_W;
  const tasks::ArmView& task = now.special.arm();
  screen.pose_target_shown = task.reference_shown;
  screen.X_WT = task.reference_shown ? task.X_WR : screen.X_WO;
  screen.turn = task.turn;
  return screen;
}

}  // namespace isograsp::session
