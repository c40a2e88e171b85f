// SPDX-License-Identifier: GPL-3.0-or-later
// From frames of a tracker to rows of a hand: times, sides, what is missing.
#include "device/hand/hand_intake.hpp"

#include "tests/device/hands/hand_trackers.hpp"
#include "tests/support/within.hpp"

namespace isograsp::hand_intake_test {
namespace {

using namespace std::chrono_literals;
using namespace isograsp::test;

constexpr double kPeriod_s = 0.01;

class Intake : public testing::Test {
 protected:
  Intake() { intake_.begin(0ns, kPeriod_s); }
  /// One frame of the tracker at a time of its own, arriving at ours.
  std::vector<HandSample> take(double tracker_s, std::vector<HandFrame> hands, double arrival_s) {
    const auto rows = intake_.take(tracker_s, hands, from_seconds(arrival_s));
    return {rows.begin(), rows.end()};
  }
  std::vector<HandSample> right(double tracker_s, double arrival_s) {
    return take(tracker_s, {made_hand(Hand::right, row_++, 0.0)}, arrival_s);
  }
  [[nodiscard]] const HandCounters& counters() const { return intake_.reception().counters; }
  HandIntake intake_{Hand::right};
  std::size_t row_ = 0;
};

TEST_F(Intake, StampsFollowTheTrackersClockAndNotTheDelaysOfTheWay) {
  constexpr double kSmallest_s = 1e-6;  // the way follows a drift of 1e-4
  std::vector<HandSample> last;
  for (int k = 0; k < 100; ++k) {
    const double late_s = k % 5 == 0 ? 0.0 : 0.004 * (k % 5);
    last = right(50.0 + kPeriod_s * k, 1.0 + kPeriod_s * k + late_s);
    ASSERT_EQ(last.size(), 1U);
    EXPECT_WITHIN(to_seconds(last[0].stamp), 1.0 + kPeriod_s * k, 5.0 * kSmallest_s);
    EXPECT_EQ(last[0].number, k);
  }
  EXPECT_EQ(counters().lost, 0U);
}

TEST_F(Intake, FramesThatAreMissingByTimeAreCountedAndLeaveTheirPlaces) {
  right(0.0, 1.0);
  const auto later = right(0.05, 1.05);
  ASSERT_EQ(later.size(), 1U);
  EXPECT_EQ(later[0].number, 5);
  EXPECT_EQ(counters().lost, 4U);
  EXPECT_EQ(intake_.reception().fault(from_seconds(1.06)), HandFault::damaged_samples);
  EXPECT_EQ(intake_.reception().fault(from_seconds(2.20)), HandFault::silence);
}

TEST_F(Intake, WhatComesBehindALaterOneIsNotGiven) {
  right(1.0, 1.0);
  right(1.02, 1.02);
  EXPECT_TRUE(right(1.01, 1.03).empty());
  EXPECT_TRUE(right(1.02, 1.03).empty()) << "the same hand twice in one frame";
  EXPECT_EQ(counters().late, 2U);
  EXPECT_EQ(counters().rows, 2U);
}

TEST_F(Intake, TwoHandsOfOneTimeMayComeOneAfterTheOther) {
  HandIntake both(std::nullopt);
  both.begin(0ns, kPeriod_s);
  const HandFrame one = made_hand(Hand::right, 0, 0.0), other = made_hand(Hand::left, 0, 0.0);
  EXPECT_EQ(both.take(1.0, std::span(&one, 1), 1s).size(), 1U);
  EXPECT_EQ(both.take(1.0, std::span(&other, 1), 1s).size(), 1U);
  EXPECT_EQ(both.reception().counters.frames, 1U);
  EXPECT_EQ(both.reception().counters.late, 0U);
}

TEST_F(Intake, AClockThatBeginsAnewOrRunsAheadIsNotBelieved) {
  right(100.0, 1.0);
  const auto back = right(0.0, 1.01);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_WITHIN(back[0].frame.t_s, 0.01, 1e-9);
  const auto ahead = right(5.0, 1.02);
  ASSERT_EQ(ahead.size(), 1U);
  EXPECT_WITHIN(ahead[0].frame.t_s, 0.02, 1e-9);
  EXPECT_LE(ahead[0].stamp, from_seconds(1.02));
  EXPECT_EQ(counters().clock_steps, 2U);
}

TEST_F(Intake, TimesOfAnySizeMakeTimesThatGoOn) {
  right(1e12, 1.0);
  double last_s = 0.0;
  for (const double t_s : {-1e12, 1e12, 0.0, -1e6}) {
    const double arrival_s = 1.0 + 0.01 * static_cast<double>(row_);
    const auto rows = right(t_s, arrival_s);
    ASSERT_EQ(rows.size(), 1U) << t_s;
    EXPECT_GT(rows[0].frame.t_s, last_s) << t_s;
    EXPECT_LT(rows[0].frame.t_s, 1.0) << t_s;
    EXPECT_LE(rows[0].stamp, from_seconds(arrival_s)) << t_s;
    last_s = rows[0].frame.t_s;
  }
}

TEST_F(Intake, TheOtherHandAloneIsSaidAfterAFifthOfASecondAndForgottenWhenItGoes) {
  right(0.0, 1.0);
  const std::vector<HandFrame> left{made_hand(Hand::left, 0, 0.0), unseen_hand(Hand::right, 0.0)};
  for (int k = 1; k <= 20; ++k) {
    take(kPeriod_s * k, left, 1.0 + kPeriod_s * k);
    ASSERT_NE(intake_.reception().fault(from_seconds(1.0 + kPeriod_s * k)), HandFault::other_hand)
        << k;
  }
  take(0.22, left, 1.22);
  EXPECT_EQ(intake_.reception().fault(from_seconds(1.22)), HandFault::other_hand);
  EXPECT_EQ(counters().other_side, 21U);
  right(0.23, 1.23);
  EXPECT_NE(intake_.reception().fault(from_seconds(1.23)), HandFault::other_hand);
}

TEST_F(Intake, BothHandsInSightAreNoFault) {
  for (int k = 0; k < 60; ++k)
    take(kPeriod_s * k, {made_hand(Hand::left, row_, 0.0), made_hand(Hand::right, row_++, 0.0)},
         1.0 + kPeriod_s * k);
  EXPECT_EQ(intake_.reception().fault(from_seconds(1.6)), HandFault::none);
  EXPECT_EQ(counters().other_side, 60U);
}

TEST_F(Intake, AHandWithoutMetacarpalsIsWholeAndOneWithoutATipIsNot) {
  HandFrame hand = made_hand(Hand::right, 0, 0.0);
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  for (const Digit digit : {Digit::index, Digit::middle, Digit::ring, Digit::little})
    hand.joints[metacarpal_joint_of(digit)] = none;
  hand.joints[kPalmJoint] = none;
  EXPECT_TRUE(take(0.0, {hand}, 1.0).at(0).frame.tracked);
  hand.joints[joint_of(Digit::little, 3)] = none;
  EXPECT_FALSE(take(0.01, {hand}, 1.01).at(0).frame.tracked);
  EXPECT_EQ(counters().incomplete, 1U);
  EXPECT_EQ(counters().untracked, 1U);
}

TEST_F(Intake, AConnectionCountsAsMadeAnewWithItsFirstFrame) {
  intake_.link(HandReception::Link::nobody);
  EXPECT_EQ(intake_.reception().link, HandReception::Link::nobody);
  intake_.link(HandReception::Link::open);
  right(0.0, 1.0);
  EXPECT_EQ(counters().restarts, 0U) << "it is the first one";
  intake_.link(HandReception::Link::nobody);
  EXPECT_EQ(intake_.reception().link, HandReception::Link::lost);
  EXPECT_EQ(intake_.reception().fault(from_seconds(1.01)), HandFault::connection_lost);
  intake_.link(HandReception::Link::open);
  EXPECT_EQ(counters().restarts, 0U);
  right(0.5, 1.5);
  EXPECT_EQ(counters().restarts, 1U);
}

TEST_F(Intake, ThePeriodIsFoundFromTheFirstFramesWhereNobodyTellsIt) {
  HandIntake unknown(Hand::right);
  unknown.begin(0ns);
  for (std::size_t k = 0; k < HandIntake::kLooks; ++k) {
    EXPECT_EQ(unknown.reception().period_s, 0.0);
    const HandFrame hand = made_hand(Hand::right, k, 0.0);
    static_cast<void>(unknown.take(static_cast<double>(k) / 30.0, std::span(&hand, 1),
                                   from_seconds(static_cast<double>(k) / 30.0)));
  }
  EXPECT_WITHIN(unknown.reception().period_s, 1.0 / 30.0, 1e-12);
}

}  // namespace
}  // namespace isograsp::hand_intake_test
