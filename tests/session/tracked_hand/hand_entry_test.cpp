// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of a session with a tracked hand.
#include "session/tracked_hand/hand_entry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::session::hand_entry_test {
namespace {

using Stage = HandEntry::Stage;
using Refusal = HandEntry::Refusal;

constexpr double kFrame_s = 0.01;

/// Ten seconds at rest, the hand lost in every `lost_each`th frame (0: never).
void rest(HandEntry& entry, int lost_each = 0) {
  for (int k = 0; k < 1000; ++k) entry.add(lost_each == 0 || k % lost_each != 0, 0.02);
}
/// Opens and closes between two gaps, twice a second, until the test ends; the seconds it took.
double open_and_close(HandEntry& entry, double least_m, double largest_m) {
  double t_s = 0.0;
  while (t_s < 100.0) {
    t_s += kFrame_s;
    const double phase = 0.5 * (1.0 - std::cos(std::numbers::pi * t_s));
    if (entry.add(true, least_m + (largest_m - least_m) * phase)) break;
  }
  return t_s;
}

TEST(HandEntry, AHandThatIsSeenAndOpensPassesAndItsOpeningLimitsTheObjects) {
  HandEntry entry(kFrame_s);
  rest(entry);
  EXPECT_EQ(entry.stage(), Stage::openings);
  const double took_s = open_and_close(entry, 0.01, 0.08);
  EXPECT_EQ(entry.stage(), Stage::ended);
  EXPECT_EQ(entry.refusal(), Refusal::none);
  EXPECT_EQ(entry.openings(), 3);
  EXPECT_LT(took_s, 6.1) << "three times two seconds";
  EXPECT_WITHIN(entry.opening_m(), 0.08, 1e-3);
  EXPECT_WITHIN(entry.widest_object_m(), 0.056, 1e-3);
}

TEST(HandEntry, AHandThatIsLostInMoreThanATenthOfTheRestIsRefused) {
  HandEntry seen(kFrame_s), lost(kFrame_s);
  rest(seen, 10);
  EXPECT_EQ(seen.stage(), Stage::openings);
  EXPECT_WITHIN(seen.tracked_share(), 0.9, 1e-12);
  rest(lost, 9);
  EXPECT_EQ(lost.stage(), Stage::ended);
  EXPECT_EQ(lost.refusal(), Refusal::badly_tracked);
}

TEST(HandEntry, AHandThatOpensLessThanThirtyMillimetresIsForTheTasksAgainstForce) {
  HandEntry entry(kFrame_s);
  rest(entry);
  open_and_close(entry, 0.012, 0.028);
  EXPECT_EQ(entry.refusal(), Refusal::opens_little);
  EXPECT_WITHIN(entry.opening_m(), 0.028, 1e-3);
}

TEST(HandEntry, AHandThatNeverOpensEndsTheTestInTime) {
  HandEntry entry(kFrame_s);
  rest(entry);
  const double took_s = open_and_close(entry, 0.02, 0.02);
  EXPECT_WITHIN(took_s, HandEntry::kLongest_s, 2.0 * kFrame_s);
  EXPECT_EQ(entry.refusal(), Refusal::opens_little);
  EXPECT_EQ(entry.openings(), 0);
}

TEST(HandEntry, OneWrongFrameIsNoOpening) {
  HandEntry entry(kFrame_s);
  rest(entry);
  for (int k = 0; k < 3000; ++k) entry.add(true, k % 100 == 50 ? 0.15 : 0.02);
  EXPECT_EQ(entry.openings(), 0);
  EXPECT_WITHIN(entry.opening_m(), 0.02, 1e-12);
}

TEST(HandEntry, GapsThatAreNoNumbersAreFramesInWhichTheHandIsNotSeen) {
  HandEntry entry(kFrame_s);
  for (int k = 0; k < 1000; ++k) entry.add(true, std::nan(""));
  EXPECT_EQ(entry.refusal(), Refusal::badly_tracked);
  EXPECT_EQ(entry.tracked_share(), 0.0);
}

TEST(HandEntry, TheGapIsThatOfThumbAndIndex) {
  HandFrame hand;
  hand.joints.fill(Vec3::Zero());
  hand.joints[joint_of(Digit::thumb, 3)] = Vec3(0.03, 0.0, 0.0);
  hand.joints[joint_of(Digit::index, 3)] = Vec3(0.0, 0.04, 0.0);
  EXPECT_WITHIN(thumb_index_gap(hand), 0.05, 1e-15);
}

}  // namespace
}  // namespace isograsp::session::hand_entry_test
