// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/tracked_hand/hand_snapshot.hpp"

#include "virtual_hand/study_plan.hpp"

namespace isograsp::session {

namespace {

ShownObject shown_object(const tasks::HandView& task) noexcept {
  const virtual_hand::ObjectShape& shape =
      virtual_hand::study_objects()[static_cast<std::size_t>(task.object)].shape;
  ShownObject object;
  object.shape = shape.kind == virtual_hand::ObjectShape::Kind::box ? ShownObject::Shape::box
                                                                    : ShownObject::Shape::cylinder;
  object.size_m = 2.0 * shape.half_m;
  object.let_go = task.let_go_asked;
  return object;
}

Cue cue_of(const EntryShown& entry) noexcept {
  if (entry.stage != HandEntry::Stage::openings) return Cue::relax;
  return entry.open ? Cue::open : Cue::close;
}

}  // namespace

Stimulus screen_of(const HandSnapshot& now) noexcept {
  Stimulus screen;
  screen.t_s = now.session_time_s;
  screen.force_shown = false;
  screen.cue = screen.page_cue = now.entry ? cue_of(*now.entry) : Cue::relax;
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
  const tasks::HandView& task = now.special.hand();
  if (task.object < 0 || !now.grasp.object_there) return screen;
  screen.object_shown = true;
  screen.virtual_object = shown_object(task);
  screen.X_WO = now.grasp.object.X_WO;
  screen.v_WO_W = now.grasp.object.v_WO_W;
  screen.w_WO_W = now.grasp.object.w_WO_W();
  screen.pose_target_shown = task.target_shown;
  screen.X_WT = task.target_shown ? task.X_WT : screen.X_WO;
  screen.pose_matched = task.let_go_asked;
  return screen;
}

}  // namespace isograsp::session
