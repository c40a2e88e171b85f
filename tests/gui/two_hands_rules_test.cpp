// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for two hands that work at once: the stricter screening, shares above rest, and a
// history of both.
#include "gui/rules/two_hands_rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "gui/rules/crosstalk_check.hpp"
#include "gui/rules/two_hands_live.hpp"

namespace isograsp::gui::test::two_hands_rules_test {
namespace {

using tasks::Effort;

Screening screening(Effort effort, int pain = 0) {
  Screening answers;
  answers.pain = pain;
  answers.allowed = effort;
  return answers;
}

TEST(BothScreenings, TheStricterOneHoldsWhicheverHandItIsOf) {
  const Effort all[] = {Effort::maximum, Effort::comfortable, Effort::none};  // ever stricter
  for (int left = 0; left < 3; ++left)
    for (int right = 0; right < 3; ++right)
      EXPECT_EQ(allowed(BothScreenings{screening(all[left]), screening(all[right])}),
                all[std::max(left, right)]);
}

TEST(BothScreenings, AreCompleteWithTheAnswersOfBothAndStoredUnderTheNameOfEach) {
  BothScreenings both{screening(Effort::maximum, 1), {}};
  EXPECT_FALSE(complete(both));
  both.right = screening(Effort::comfortable, 3);
  both.right.applies[static_cast<std::size_t>(Caution::skin)] = true;
  ASSERT_TRUE(complete(both));
  EXPECT_TRUE(applies_to_one(both, Caution::skin));
  EXPECT_FALSE(applies_to_one(both, Caution::seizures));
  std::map<std::string, std::string> of;
  for (const auto& answer : stored(both)) {
    EXPECT_EQ(answer.topic, "screening");
    EXPECT_TRUE(of.emplace(answer.item, answer.value).second) << answer.item << " stands twice";
  }
  EXPECT_EQ(of["left_pain"], "1");
  EXPECT_EQ(of["right_pain"], "3");
  EXPECT_EQ(of["left_skin_or_sensation"], "no");
  EXPECT_EQ(of["right_skin_or_sensation"], "yes");
  EXPECT_EQ(of["left_allowed"], "maximum");
  EXPECT_EQ(of["right_allowed"], "comfortable");
}

TEST(HandsSafetyRule, NeedsTheStopAndSomebodyWithinReachAndStoresBoth) {
  HandsSafety safety;
  EXPECT_FALSE(safety.complete());
  safety.stop_tested = true;
  EXPECT_FALSE(safety.complete());
  safety.within_reach = true;
  EXPECT_TRUE(safety.complete());
  std::map<std::string, std::string> of;
  for (const auto& answer : stored(safety)) of[answer.item] = answer.value;
  EXPECT_EQ(of, (std::map<std::string, std::string>{{"stop_tested", "yes"},
                                                    {"within_reach", "yes"},
                                                    {"less_affected_hand_strapped", "no"}}));
}

/// Presses of which the other platform feels a share, with what it felt before.
class Bench {
 public:
  explicit Bench(double share) : share_(share) { check.begin(); }
  /// Net push on one platform for a while, at 60 looks a second.
  void press(Hand hand, double force_N, double lasts_s) {
    for (int k = 0; k < static_cast<int>(60.0 * lasts_s); ++k) {
      session::TwoPlatformsSnapshot now;
      now.session_time_s = t_s_ += 1.0 / 60.0;
      now.of[hand].push_W = Vec3(0.6 * force_N, -0.8 * force_N, 0.0);
      now.of[other_than(hand)].push_W = Vec3(0.3, 0.0, share_ * force_N);
      check.add(now);
    }
  }
  CrossTalkCheck check;

 private:
  double share_;
  double t_s_ = 0.0;
};

TEST(CrossTalk, IsWhatTheOtherPlatformFeelsOfTwentyNewtonsBothWays) {
  for (const double share : {0.0, 0.005, 0.02, 0.2}) {
    Bench bench(share);
    for (const Hand hand : kBothHands) {
      bench.press(hand, 0.0, 0.5);
      bench.press(hand, 25.0, 1.0);
    }
    ASSERT_EQ(bench.check.state(), CrossTalkCheck::State::over) << share;
    constexpr double kRounding = 1e-9;  // means of some thirty sums
    EXPECT_NEAR(bench.check.moved_percent(), 100.0 * share, kRounding);
    EXPECT_NEAR(bench.check.ways().left->pressed_N, 25.0, kRounding);
    EXPECT_EQ(bench.check.coupled(), share > 0.01) << share;
  }
}

TEST(CrossTalk, ASoftPressOrOneThatWasThereBeforeCountsForNothing) {
  Bench soft(0.2);
  soft.press(Hand::left, 0.0, 0.5);
  soft.press(Hand::left, 19.0, 3.0);
  EXPECT_EQ(soft.check.state(), CrossTalkCheck::State::press_left);
  Bench before(0.2);
  before.press(Hand::left, 25.0, 3.0);
  EXPECT_EQ(before.check.state(), CrossTalkCheck::State::press_left)
      << "nobody knows what the other one felt before";
  Bench short_press(0.2);
  short_press.press(Hand::left, 0.0, 0.5);
  short_press.press(Hand::left, 25.0, 0.3);
  short_press.press(Hand::left, 0.0, 0.5);
  short_press.press(Hand::left, 25.0, 0.3);
  EXPECT_EQ(short_press.check.state(), CrossTalkCheck::State::press_left);
}

TEST(CrossTalk, IsStoredWithItsOutcomeOrAsSkipped) {
  const auto of = [](const CrossTalkCheck& check) {
    std::map<std::string, std::string> said;
    for (const auto& answer : stored(check)) said[answer.item] = answer.value;
    return said;
  };
  Bench bench(0.02);
  for (const Hand hand : kBothHands) {
    bench.press(hand, 0.0, 0.5);
    bench.press(hand, 25.0, 1.0);
  }
  EXPECT_EQ(of(bench.check),
            (std::map<std::string, std::string>{{"outcome", "coupled"},
                                                {"left_pressed_N", "25.00"},
                                                {"left_moves_other_percent", "2.00"},
                                                {"right_pressed_N", "25.00"},
                                                {"right_moves_other_percent", "2.00"}}));
  bench.check.skip();
  EXPECT_TRUE(bench.check.settled());
  EXPECT_FALSE(bench.check.coupled());
  EXPECT_EQ(of(bench.check), (std::map<std::string, std::string>{{"outcome", "skipped"}}));
}

HandsHistory pressed(double left_N, double right_N, double lasts_s = 2.0) {
  HandsHistory history;
  for (int k = 0; k <= static_cast<int>(lasts_s * 100.0); ++k) {
    session::TwoPlatformsSnapshot now;
    now.frames = k + 1;
    now.session_time_s = 0.01 * k;
    now.of.left.grip_N = left_N;
    now.of.right.grip_N = right_N;
    history.add(now);
  }
  return history;
}

tasks::TwoHandsReferences references(double left_rest_N, double right_rest_N) {
  tasks::TwoHandsReferences known;
  known.of.left.resting_N = left_rest_N;
  known.of.right.resting_N = right_rest_N;
  known.of.left.maximum_N = 10.0;
  known.of.right.maximum_N = 30.0;
  known.affected = Hand::left;
  return known;
}

constexpr double kRounding = 1e-9;  // means of a hundred sums

TEST(HandsLiveShare, IsAboveRestAndOfEffortByWhatEachCanDo) {
  const HandsLive live = hands_live(pressed(2.0, 6.0), references(0.0, 0.0));
  ASSERT_TRUE(live.share_affected_percent && live.effort_share_affected_percent);
  EXPECT_NEAR(*live.share_affected_percent, 25.0, kRounding);
  EXPECT_NEAR(*live.effort_share_affected_percent, 50.0, kRounding);
  const HandsLive toned = hands_live(pressed(6.0, 6.0), references(4.0, 0.0));
  EXPECT_NEAR(*toned.share_affected_percent, 25.0, kRounding);
}

TEST(HandsLiveShare, AHandWithToneAndNoEffortHasNone) {
  const HandsLive live = hands_live(pressed(4.0, 6.0), references(4.0, 0.0));
  ASSERT_TRUE(live.share_affected_percent);
  EXPECT_NEAR(*live.share_affected_percent, 0.0, kRounding);
}

TEST(HandsLiveShare, IsOfTheSideThatIsAffected) {
  auto known = references(0.0, 0.0);
  known.affected = Hand::right;
  EXPECT_NEAR(*hands_live(pressed(2.0, 6.0), known).share_affected_percent, 75.0, kRounding);
}

TEST(HandsLiveShare, IsNotToldWhereARestOrTheSideIsNotKnownOrBothRest) {
  auto known = references(0.0, 0.0);
  EXPECT_FALSE(hands_live(pressed(0.1, 0.1), known).share_affected_percent) << "noise";
  EXPECT_FALSE(hands_live(HandsHistory{}, known).share_affected_percent);
  known.of.right.maximum_N.reset();
  const HandsLive without = hands_live(pressed(2.0, 6.0), known);
  EXPECT_TRUE(without.share_affected_percent);
  EXPECT_FALSE(without.effort_share_affected_percent);
  known.of.right.resting_N.reset();
  EXPECT_FALSE(hands_live(pressed(2.0, 6.0), known).share_affected_percent);
  known = references(0.0, 0.0);
  known.affected.reset();
  EXPECT_FALSE(hands_live(pressed(2.0, 6.0), known).share_affected_percent);
}

TEST(HandsHistoryOfAPlot, ForgetsWhatIsOldAndInventsNoSample) {
  HandsHistory history = pressed(1.0, 2.0, 30.0);
  EXPECT_LE(history.points().back().t_s - history.points().front().t_s, 20.0);
  session::TwoPlatformsSnapshot now;
  now.frames = 9000;
  now.session_time_s = 31.0;
  now.of.left.forces.flags[0] = bit(SampleFlag::missing);
  history.add(now);
  EXPECT_TRUE(std::isnan(history.points().back().force_N.left));
  EXPECT_TRUE(std::isnan(history.points().back().sum_N()));
  EXPECT_FALSE(std::isnan(history.points().back().force_N.right));
  EXPECT_GE(history.range().most_N, 3.0);
}

}  // namespace
}  // namespace isograsp::gui::test::two_hands_rules_test
