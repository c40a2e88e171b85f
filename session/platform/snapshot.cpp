// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/platform/snapshot.hpp"

#include <algorithm>

namespace isograsp::session {

namespace {

ShownProgress shown_progress(const tasks::TaskProgress& task) noexcept {
  return {task.phase == tasks::Phase::lead_in,
          task.phase == tasks::Phase::hold,
          task.task_time_s,
          task.duration_s,
          task.segment,
          task.target_index,
          task.target_count,
          task.targets_reached,
          task.hold_fraction};
}

void show_force(const Snapshot& now, Stimulus& screen) noexcept {
  const tasks::ForceView& force = now.special.force();
  screen.channel = force.channel;
  screen.force_target_shown = force.force_target_shown;
  if (force.force_target_shown) screen.target_force_N = force.target_force_N;
  screen.force_shown = force.force_shown;
  if (force.force_shown) screen.shown_force_N = force.actual_force_N;
  screen.digit_targets = force.digit_targets;
  if (!force.force_shown) return;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    if (force.digit_targets.shown[f]) screen.digit_force_C[f] = now.forces.wrench_C[f].force;
}

void show_object(const Snapshot& now, Stimulus& screen) noexcept {
  const tasks::ObjectView& object = now.special.object();
  screen.object_shown = true;
  screen.X_WO = now.object.X_WO;
  screen.v_WO_W = now.object.v_WO_W;
  screen.w_WO_W = now.object.w_WO_W;
  screen.pose_target_shown = object.pose_target_shown;
  screen.X_WT = object.pose_target_shown ? object.X_WT : now.object.X_WO;
  screen.contact = now.grasp.contact;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    screen.press_N[f] = std::max(0.0, now.forces.wrench_C[f].force.z());
}

}  // namespace

Stimulus page_of(const Moment& now) noexcept {
  Stimulus screen;
  screen.t_s = now.session_time_s;
  if (now.stage != Stage::trial && now.stage != Stage::paused) {
    screen.cue = now.stage == Stage::zeroing || !now.zeroed ? Cue::hand_out : Cue::relax;
    screen.page_cue = screen.cue;
    return screen;
  }
  screen.page_cue = now.task.cue;
  screen.cue = now.stage == Stage::paused ? Cue::relax : screen.page_cue;
  screen.progress = shown_progress(now.task);
  return screen;
}

Stimulus screen_of(const Snapshot& now) noexcept {
  Stimulus screen = page_of(now);
  if (now.stage != Stage::trial && now.stage != Stage::paused) return screen;
  show_force(now, screen);
  if (now.has_object) show_object(now, screen);
  return screen;
}

NetPush net_push(const Platform& platform, const FingerFrame& forces, double grip_N) noexcept {
  NetPush push;
  push.known = !forces.any(SampleFlag::missing);
  if (!push.known) return push;
  push.wrench_P = net_wrench(platform, forces.wrench_C);
  if (grip_N >= kLeastGripForPush_N)
    push.share_of_grip_percent = 100.0 * push.wrench_P.force.norm() / grip_N;
  return push;
}

}  // namespace isograsp::session
