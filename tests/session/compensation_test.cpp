// SPDX-License-Identifier: GPL-3.0-or-later
// Push of the arm and fingers that slide: told apart from noise and from gaps.
#include "session/compensation.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::session::compensation_test {
namespace {

constexpr double kPeriod_s = 0.01;

class Watched : public ::testing::Test {
 protected:
  void press(const Eigen::Vector2d& place_m, double duration_s, double noise_m = 0.0) {
    std::normal_distribution<double> noise(0.0, 1.0);
    for (int k = 0; k < std::lround(duration_s / kPeriod_s); ++k) {
      snapshot_.session_time_s += kPeriod_s;
      ++snapshot_.frames;
      snapshot_.centre_of_pressure[1] =
          place_m + noise_m * Eigen::Vector2d(noise(random_), noise(random_));
      watch_.add(snapshot_);
    }
  }
  Snapshot snapshot_;
  Compensation watch_;
  std::mt19937_64 random_{7};
};

TEST_F(Watched, AFingerThatStaysHasNotMovedHoweverNoisyItsMomentsAre) {
  press({0.002, -0.001}, 20.0, 0.004);
  ASSERT_TRUE(watch_.pad_shift_m(Finger::index));
  EXPECT_LT(*watch_.pad_shift_m(Finger::index), kRemarkablePadShift_m / 2);
  EXPECT_FALSE(watch_.pad_shift_m(Finger::thumb)) << "it never pressed";
}

TEST_F(Watched, AFingerThatSlidIsSaidToHaveMovedAsFar) {
  press({0.0, 0.0}, 1.0);
  press({0.0, 0.007}, 10.0);
  constexpr double kSettled_m = 1e-10;  // after twenty time constants
  EXPECT_WITHIN(*watch_.pad_shift_m(Finger::index), 0.007, kSettled_m);
  watch_.strapped();
  EXPECT_FALSE(watch_.pad_shift_m(Finger::index)) << "seated anew";
  press({0.0, 0.007}, 1.0);
  EXPECT_WITHIN(*watch_.pad_shift_m(Finger::index), 0.0, kSettled_m);
}

TEST_F(Watched, WithoutPressingNothingMoves) {
  press({0.0, 0.0}, 1.0);
  snapshot_.centre_of_pressure[1].reset();
  for (int k = 0; k < 1000; ++k) {
    snapshot_.session_time_s += kPeriod_s;
    watch_.add(snapshot_);
  }
  EXPECT_EQ(*watch_.pad_shift_m(Finger::index), 0.0);
}

TEST_F(Watched, ThePushIsAveragedAndEndsWithTheGrip) {
  snapshot_.push.share_of_grip_percent = 30.0;
  press({0.0, 0.0}, 5.0);
  EXPECT_WITHIN(*watch_.push_percent(), 30.0, 1e-9);
  snapshot_.push.share_of_grip_percent = 0.0;
  press({0.0, 0.0}, 1.0);
  EXPECT_WITHIN(*watch_.push_percent(), 30.0 * std::exp(-1.0), 1e-9);
  snapshot_.push.share_of_grip_percent.reset();
  press({0.0, 0.0}, kPeriod_s);
  EXPECT_FALSE(watch_.push_percent());
}

TEST_F(Watched, ASlipOnTheObjectIsSeenLongEnoughToReadIt) {
  snapshot_.stage = Stage::trial;
  snapshot_.has_object = true;
  press({0.0, 0.0}, 1.0);
  EXPECT_FALSE(watch_.slips(Finger::index));
  snapshot_.grasp.slip[1] = true;
  press({0.0, 0.0}, kPeriod_s);
  snapshot_.grasp.slip[1] = false;
  EXPECT_TRUE(watch_.slips(Finger::index));
  EXPECT_FALSE(watch_.slips(Finger::thumb));
  press({0.0, 0.0}, 1.9);
  EXPECT_TRUE(watch_.slips(Finger::index));
  press({0.0, 0.0}, 0.2);
  EXPECT_FALSE(watch_.slips(Finger::index));
  snapshot_.has_object = false;
  snapshot_.grasp.slip[1] = true;  // left over from another trial
  press({0.0, 0.0}, 0.1);
  EXPECT_FALSE(watch_.slips(Finger::index));
}

TEST_F(Watched, WithoutSamplesNothingIsAlarming) {
  for (int look = 0; look < 2; ++look) {
    for (const Finger finger : kFingers) {
      EXPECT_FALSE(watch_.slips(finger));
      EXPECT_FALSE(watch_.pad_shift_m(finger));
    }
    EXPECT_FALSE(watch_.push_percent());
    snapshot_.stage = Stage::trial;  // a session is open, and no frame has come
    snapshot_.has_object = snapshot_.grasp.slip[1] = true;
    watch_.add(snapshot_);
  }
}

TEST_F(Watched, TheSameFrameCountsOnce) {
  press({0.0, 0.0}, 1.0);
  snapshot_.centre_of_pressure[1] = Eigen::Vector2d(0.02, 0.0);
  for (int k = 0; k < 100; ++k) watch_.add(snapshot_);
  EXPECT_EQ(*watch_.pad_shift_m(Finger::index), 0.0);
}

}  // namespace
}  // namespace isograsp::session::compensation_test
