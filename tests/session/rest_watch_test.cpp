// SPDX-License-Identifier: GPL-3.0-or-later
// After a fault work goes on from rest only.
#include "session/rest_watch.hpp"

#include <gtest/gtest.h>

namespace isograsp::session::rest_watch_test {
namespace {

class Rest : public ::testing::Test {
 protected:
  void pass(double duration_s, double thumb_N, std::uint8_t flags = 0) {
    snapshot_.forces.wrench_C[0].force.z() = thumb_N;
    snapshot_.forces.flags[0] = flags;
    for (double t_s = 0.0; t_s < duration_s; t_s += 0.01) {
      snapshot_.session_time_s += 0.01;
      watch_.add(snapshot_);
    }
  }
  Snapshot snapshot_;
  RestWatch watch_;
};

TEST_F(Rest, NeedsHalfASecondInARow) {
  watch_.begin(std::nullopt);
  pass(0.4, 0.2);
  EXPECT_FALSE(watch_.at_rest());
  pass(0.02, 3.0);
  pass(0.4, 0.2);
  EXPECT_FALSE(watch_.at_rest());
  pass(0.2, 0.2);
  EXPECT_TRUE(watch_.at_rest());
}

TEST_F(Rest, AFingerWithoutAValueIsNotAtRest) {
  watch_.begin(std::nullopt);
  pass(1.0, 0.0);
  pass(1.0, 0.0, bit(SampleFlag::held));
  EXPECT_FALSE(watch_.at_rest());
}

TEST_F(Rest, ATimeThatNobodyLookedAtIsNoRest) {
  watch_.begin(std::nullopt);
  pass(0.1, 0.2);
  snapshot_.session_time_s += 0.6;
  pass(0.02, 0.2);
  EXPECT_FALSE(watch_.at_rest());
  pass(0.5, 0.2);
  EXPECT_TRUE(watch_.at_rest());
}

TEST_F(Rest, ToneIsRestAndAZeroThatMovedIsNot) {
  FingerWrenches tone{};
  tone[0].force.z() = 3.0;
  watch_.begin(tone);
  pass(1.0, 3.3);
  EXPECT_TRUE(watch_.at_rest()) << "as this hand is at rest";
  pass(1.0, 3.0 + 1.5 * kRestBand_N);
  EXPECT_FALSE(watch_.at_rest());
}

}  // namespace
}  // namespace isograsp::session::rest_watch_test
