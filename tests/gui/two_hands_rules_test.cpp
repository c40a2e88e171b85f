// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for two hands that work at once: the stricter screening, shares above rest, and a
// history of both.
#include "gui/rules/two_hands_rules.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

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
