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
  return screen;
}

}  // namespace isograsp::session
