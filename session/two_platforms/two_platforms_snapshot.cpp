// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/two_platforms/two_platforms_snapshot.hpp"

#include "session/platform/snapshot.hpp"

namespace isograsp::session {

namespace {

ShownHand shown(const tasks::HandAsked& of) noexcept {
  ShownHand hand;
  hand.cue = of.cue;
  hand.target_shown = of.target_N.has_value();
  hand.target_force_N = of.target_N.value_or(0.0);
  hand.force_shown = of.force_shown;
  if (of.force_shown) hand.force_N = of.force_N;
  return hand;
}

/// @pre now.lifted and a task that says what is to be done with it
ShownTray shown(const LiftedView& seen, const tasks::MovedView& asked) noexcept {
  ShownTray tray;
  tray.size_m = seen.size_m;
  tray.X_WO = seen.object.X_WO;
  tray.v_WO_W = seen.object.v_WO_W;
  tray.w_WO_W = seen.object.w_WO_W;
  tray.target_shown = asked.target_shown;
  tray.X_WT = asked.target_shown ? asked.X_WT : asked.rest_X_WO;
  tray.X_WR = asked.rest_X_WO;
  tray.band_m = asked.band.position_m;
  tray.band_rad = asked.band.angle_rad;
  tray.fetched = asked.fetched;
  for (const Hand hand : kBothHands) {
    tray.end_O[hand] = seen.of[hand].end_O;
    tray.touches[hand] = seen.of[hand].touches;
    tray.slips[hand] = seen.of[hand].slips;
  }
  return tray;
}

/// @pre now.carried and a task that says what is to be done with it
ShownCarry shown(const CarriedView& seen, const tasks::MovedView& asked) noexcept {
  ShownCarry carry;
  carry.size_m = seen.size_m;
  carry.X_WO = seen.object.X_WO;
  carry.v_WO_W = seen.object.v_WO_W;
  carry.half_size_m = seen.half_size_m;
  carry.held = seen.held;
  carry.clutch = seen.clutch;
  carry.target_shown = asked.target_shown;
  carry.X_WT = asked.target_shown ? asked.X_WT : asked.rest_X_WO;
  carry.tolerance_m = asked.band.position_m;
  carry.fetched = asked.fetched;
  for (const Hand hand : kBothHands)
    carry.of[hand] = {seen.of[hand].p_W, seen.of[hand].bubble_W, seen.of[hand].excess > 0.0};
  return carry;
}

}  // namespace

Vec3 push_in_view(Hand hand, const Vec3& force_P) noexcept {
  return hand == Hand::right ? force_P : Vec3(-force_P.x(), force_P.y(), -force_P.z());
}

Stimulus screen_of(const TwoPlatformsSnapshot& now) noexcept {
  Stimulus screen = page_of(now);
  if (now.stage != Stage::trial && now.stage != Stage::paused) return screen;
  const tasks::TwoHandsView& task = now.special.two_hands();
  ShownHands& hands = screen.hands.emplace();
  for (const Hand hand : kBothHands) hands.of[hand] = shown(task.of[hand]);
  hands.sum.target_shown = task.target_sum_N.has_value();
  hands.sum.target_force_N = task.target_sum_N.value_or(0.0);
  hands.sum.force_shown = task.sum_shown;
  if (task.sum_shown) hands.sum.force_N = task.of.left.force_N + task.of.right.force_N;
  if (now.lifted && task.moved) hands.tray = shown(*now.lifted, *task.moved);
  if (now.carried && task.moved) hands.carry = shown(*now.carried, *task.moved);
  return screen;
}

}  // namespace isograsp::session
