// SPDX-License-Identifier: GPL-3.0-or-later
// What the therapist reads of a tracked hand: numbers of the frame, and of the tracker's counters.
#include "gui/rules/hand_live.hpp"

#include <gtest/gtest.h>

namespace isograsp::gui::hand_live_test {
namespace {

using virtual_hand::DigitState;

session::HandSnapshot in_a_placement() {
  session::HandSnapshot now;
  now.frames = 1;
  auto& task = now.special.special.emplace<tasks::HandView>();
  task.object = 4;
  task.placement = 2;
  task.fails = 1;
  task.assistance = virtual_hand::AssistanceLevel::softer;
  now.grasp.object_there = true;
  now.release_N = 0.4;
  return now;
}

TEST(HandLive, WithoutAnObjectThereIsNothingToRead) {
  EXPECT_FALSE(grasp_live({}));
  auto now = in_a_placement();
  now.grasp.object_there = false;
  EXPECT_FALSE(grasp_live(now));
}

TEST(HandLive, ThePullOfATiedDigitIsAShareOfTheOneThatLetsGoAndOthersHaveNone) {
  auto now = in_a_placement();
  now.grasp.digits[0].state = DigitState::attached;
  now.grasp.digits[0].pull_N = 0.1;
  now.grasp.digits[1].state = DigitState::attached;
  now.grasp.digits[1].pull_N = 0.9;
  now.grasp.digits[2].state = DigitState::contact;
  const auto live = grasp_live(now);
  ASSERT_TRUE(live);
  EXPECT_DOUBLE_EQ(*live->digits[0].share, 0.25);
  EXPECT_DOUBLE_EQ(*live->digits[1].share, 1.0) << "a bar is full at the most";
  EXPECT_FALSE(live->digits[2].share);
  EXPECT_EQ(live->digits[2].state, DigitState::contact);
  EXPECT_EQ(live->placement, 2);
  EXPECT_EQ(live->fails, 1);
  EXPECT_EQ(live->level, virtual_hand::AssistanceLevel::softer);
  now.release_N = tasks::kNotMeasured;  // without help nothing is tied
  EXPECT_FALSE(grasp_live(now)->release_N);
  EXPECT_FALSE(grasp_live(now)->digits[0].share);
}

TEST(HandLive, CriteriaStandBesideTheLimitsThatCount) {
  auto now = in_a_placement();
  for (const auto& criterion : grasp_live(now)->criteria) EXPECT_FALSE(criterion);
  virtual_hand::GraspChoice& choice = now.grasp.choice;
  choice.digits = 0b00011;
  choice.G_min = 0.5;
  choice.G_min_limit = 0.4;
  choice.H_min = 0.01;
  choice.H_min_limit = 0.03;
  choice.H_det = choice.H_det_limit = 1e-4;
  const auto two = grasp_live(now)->criteria;
  EXPECT_TRUE(two[0]->met());
  EXPECT_FALSE(two[1]->met());
  EXPECT_FALSE(two[2]->met()) << "above it, not at it";
  choice.digits = 0b00111;
  choice.H_min_limit = 0.0;
  EXPECT_FALSE(grasp_live(now)->criteria[1]) << "of three digits it does not count";
}

TEST(TrackerWatch, CountsRowsASecondAndThoseWithoutTheHandInTheLastTenSeconds) {
  TrackerWatch watch;
  session::HandSnapshot now;
  EXPECT_FALSE(watch.rate_Hz());
  constexpr double kRate_Hz = 90.0;
  constexpr double kPeriod_s = 0.01;
  const auto let_pass = [&](double duration_s, double unseen, double missing) {
    const double begin_s = now.session_time_s;
    const HandCounters before = now.health.counters;
    for (int k = 1; k <= static_cast<int>(duration_s / kPeriod_s); ++k) {
      ++now.frames;
      now.session_time_s = begin_s + k * kPeriod_s;
      now.hand.held = unseen > 0.0 && (k - 1) % 100 < 100 * unseen;
      const double due = kRate_Hz * k * kPeriod_s;
      HandCounters& count = now.health.counters;
      count.rows = before.rows + static_cast<std::uint64_t>(due * (1.0 - missing));
      count.lost = before.lost + static_cast<std::uint64_t>(due * missing);
      count.untracked = before.untracked + static_cast<std::uint64_t>(due * unseen);
      watch.add(now);
      watch.add(now);  // the same frame counts once
    }
  };
  let_pass(0.5, 0.0, 0.0);
  EXPECT_FALSE(watch.rate_Hz()) << "a few rows tell no rate";
  let_pass(20.0, 0.2, 0.0);
  EXPECT_NEAR(*watch.rate_Hz(), kRate_Hz, 1.0);
  EXPECT_NEAR(*watch.lost_percent(), 20.0, 1.0);
  EXPECT_EQ(watch.gaps(), 20);
  let_pass(10.5, 0.0, 0.5);
  EXPECT_NEAR(*watch.rate_Hz(), kRate_Hz / 2.0, 1.0);
  EXPECT_NEAR(*watch.lost_percent(), 50.0, 1.0) << "what was before is forgotten";
  EXPECT_EQ(watch.gaps(), 20);
}

}  // namespace
}  // namespace isograsp::gui::hand_live_test
