// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a tracker as frames of a session, and what a lost hand means for it.
#include "session/tracked_hand/hand_reader.hpp"

#include <gtest/gtest.h>

#include "session/tracked_hand/hand_sight.hpp"
#include "tests/session/tracked_hand/scripted_hands.hpp"
#include "tests/support/must.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::hand_reader_test {
namespace {

using test::hand_at;
using test::ScriptedHands;
using Rows = std::vector<ScriptedHands::Row>;
using Sight = Reception::Sight;

constexpr double kFrame_s = 0.01;
constexpr double kRounding = 1e-6;  // stamps are whole nanoseconds

/// A hand that goes along x at this speed, `rate_Hz` rows a second.
Rows moving(double speed_m_s, double rate_Hz, double until_s) {
  Rows rows;
  for (int k = 0; k / rate_Hz <= until_s; ++k)
    rows.push_back({k / rate_Hz, hand_at(speed_m_s * k / rate_Hz)});
  return rows;
}
/// All frames of a session until the tracker ends, or for so many.
std::vector<ShownHand> frames_of(ScriptedHands& device, int most, Hand side = Hand::right) {
  ManualClock clock;
  test::must(device.start(clock));
  HandReader reader(device, side, kFrame_s, Timestamp{0});
  std::vector<ShownHand> shown;
  for (int k = 0; k < most && reader.next(); ++k) shown.push_back(reader.hand());
  return shown;
}
double x_of(const ShownHand& hand) {
  return hand.frame.joints[kWristJoint].x();
}

TEST(HandReader, ASteadyHandIsShownOnePeriodLateWhateverTheRateOfTheTracker) {
  constexpr double kSpeed = 0.4;
  for (const double rate_Hz : {30.0, 90.0, 120.0}) {
    ScriptedHands device(moving(kSpeed, rate_Hz, 1.0), 1.0 / rate_Hz);
    const auto shown = frames_of(device, 100);
    ASSERT_EQ(shown.size(), 100U);
    for (int k = 10; k < 100; ++k) {
      const ShownHand& hand = shown[static_cast<std::size_t>(k)];
      EXPECT_WITHIN(x_of(hand), kSpeed * (k * kFrame_s - 1.0 / rate_Hz), kRounding) << rate_Hz;
      EXPECT_FALSE(hand.held);
      EXPECT_EQ(hand.unseen_s, 0.0);
    }
  }
}

TEST(HandReader, BeforeTheFirstRowNoHandIsKnown) {
  ScriptedHands device({{0.1, hand_at(1.0)}, {0.11, hand_at(1.0)}}, kFrame_s);
  const auto shown = frames_of(device, 30);
  EXPECT_FALSE(shown[5].known);
  EXPECT_FALSE(shown[5].frame.joints[kWristJoint].allFinite());
  EXPECT_EQ(hand_reception(shown[0], HandFault::none).sight, Sight::occluded);
  EXPECT_TRUE(shown[15].known);
}

TEST(HandReader, ALostHandStandsStillThenTheTrialWaitsAndGoesOnByItself) {
  Rows rows = moving(0.5, 100.0, 2.0);
  for (auto& row : rows)
    if (row.stamp_s > 0.995 && row.stamp_s < 1.395) row.frame = hand_at(0.0, false);
  ScriptedHands device(rows, kFrame_s);
  const auto shown = frames_of(device, 200);
  int held = 0, waits = 0;
  for (std::size_t k = 20; k < shown.size(); ++k) {
    const Reception reception = hand_reception(shown[k], HandFault::none);
    ASSERT_NE(reception.sight, Sight::lost);
    EXPECT_EQ(reception.gap, shown[k].held);
    EXPECT_LT(std::abs(x_of(shown[k]) - x_of(shown[k - 1])), 0.25) << "it never jumps to nowhere";
    if (!shown[k].held) continue;
    EXPECT_WITHIN(x_of(shown[k]), 0.5 * 0.99, kRounding) << "where it was seen last";
    ++(reception.sight == Sight::clear ? held : waits);
  }
  EXPECT_EQ(held, 20) << "0.2 s";
  EXPECT_EQ(waits, 20) << "the rest of 0.4 s";
  EXPECT_FALSE(shown.back().held);
}

TEST(HandReader, ARowThatIsMissingIsFilledInAndALongGapIsNot) {
  Rows rows = moving(0.5, 100.0, 2.0);
  std::erase_if(rows, [](const auto& row) {
    return (row.stamp_s > 0.495 && row.stamp_s < 0.505) ||
           (row.stamp_s > 0.995 && row.stamp_s < 1.255);
  });
  ScriptedHands device(rows, kFrame_s);
  const auto shown = frames_of(device, 200);
  const ShownHand& between_rows = shown[51];
  EXPECT_TRUE(between_rows.frame.joints[kWristJoint].allFinite());
  EXPECT_WITHIN(x_of(shown[53]), 0.5 * 0.52, kRounding) << "and it goes on where it is";
  EXPECT_TRUE(shown[115].held);
  EXPECT_WITHIN(x_of(shown[115]), 0.5 * 0.99, kRounding);
  EXPECT_WITHIN(x_of(shown[140]), 0.5 * 1.39, kRounding);
}

TEST(HandReader, ATrackerThatSendsNothingIsAFaultOfTheDeviceAndNoPauseThatGoesOnByItself) {
  ScriptedHands device(moving(0.5, 100.0, 0.5), kFrame_s);
  const auto shown = frames_of(device, 100);
  EXPECT_EQ(hand_reception(shown.back(), HandFault::silence).sight, Sight::lost);
  EXPECT_EQ(hand_reception(shown.back(), HandFault::connection_lost).sight, Sight::lost);
  EXPECT_EQ(hand_reception(shown[30], HandFault::frozen).sight, Sight::lost)
      << "although the hand seems to be there";
  EXPECT_EQ(hand_reception(shown.back(), HandFault::other_hand).sight, Sight::occluded);
  EXPECT_EQ(hand_reception(shown[30], HandFault::damaged_samples).sight, Sight::clear);
}

TEST(HandReader, RowsOfTheOtherHandAreNeverShown) {
  Rows rows;
  for (int k = 0; k < 100; ++k) {
    rows.push_back({k * kFrame_s, hand_at(-5.0, true, Hand::left)});
    rows.push_back({k * kFrame_s, hand_at(1.0)});
  }
  ScriptedHands device(rows, kFrame_s);
  const auto shown = frames_of(device, 100);
  for (std::size_t k = 10; k < 90; ++k) EXPECT_EQ(x_of(shown[k]), 1.0);
}

TEST(HandReader, RowsThatComeLateAndInBurstsAreShownAtTheirTimes) {
  Rows rows = moving(0.5, 100.0, 1.0);
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].late_s = 0.004 * static_cast<double>(k % 3);
  ScriptedHands device(rows, kFrame_s);
  const auto shown = frames_of(device, 90);
  for (std::size_t k = 10; k < 90; ++k) {
    EXPECT_FALSE(shown[k].held) << k;
    // The row of the instant itself is there: it is one period old.
    EXPECT_WITHIN(x_of(shown[k]), 0.5 * (static_cast<double>(k) - 1.0) * kFrame_s, kRounding);
  }
}

TEST(HandReader, EndsWithItsRecordingAndAllocatesNothing) {
  ScriptedHands device(moving(0.5, 100.0, 0.5), kFrame_s);
  device.ends = true;
  ManualClock clock;
  test::must(device.start(clock));
  HandReader reader(device, Hand::right, kFrame_s, Timestamp{0});
  const auto before = test::allocations();
  int frames = 0;
  while (frames < 1000 && reader.next()) ++frames;
  EXPECT_EQ(test::allocations(), before);
  EXPECT_NEAR(frames, 52, 1);
  EXPECT_WITHIN(reader.hand().frame.joints[kWristJoint].x(), 0.25, 0.006);
}

}  // namespace
}  // namespace isograsp::session::hand_reader_test
