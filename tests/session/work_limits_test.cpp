// SPDX-License-Identifier: GPL-3.0-or-later
// When a session has asked enough of a hand.
#include "session/work_limits.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace isograsp::session::work_limits_test {
namespace {

std::vector<Measure> maximum(double value_N, const char* channel = "grip") {
  Measure measure;
  measure.name = "maximum_force";
  measure.channel = channel;
  measure.value = value_N;
  return {measure};
}

TEST(WorkLimits, HalfAnHourOfWorkIsEnoughHoweverItIsDivided) {
  for (const int trials : {1, 7, 60}) {
    WorkLimits limits;
    limits.begin(false);
    for (int i = 0; i < trials; ++i) {
      EXPECT_FALSE(limits.reason_to_stop()) << i << " of " << trials;
      limits.worked(kMostWork_s / trials * (1.0 + 1e-12));
    }
    EXPECT_EQ(english(limits.reason_to_stop().value_or(Text())),
              "30 minutes of work are done: end the session for today.");
  }
}

TEST(WorkLimits, AFifthOfTheForceLostEndsTheWorkAndAForceThatComesBackDoesNot) {
  WorkLimits limits;
  limits.begin(false);
  limits.tried(maximum(20.0));
  limits.tried(maximum(16.1));
  EXPECT_FALSE(limits.reason_to_stop());
  limits.tried(maximum(15.0, "thumb"));
  EXPECT_FALSE(limits.reason_to_stop()) << "another channel has its own best";
  limits.tried(maximum(16.0));
  EXPECT_EQ(
      english(limits.reason_to_stop().value_or(Text())),
      "The maximum has fallen by 20 % in this session: stop the work of this hand for today.");
  limits.tried(maximum(18.0));
  EXPECT_FALSE(limits.reason_to_stop());
}

TEST(WorkLimits, AMaximumInWhichTheTherapistHelpedIsTakenOutAndComesBack) {
  WorkLimits limits;
  limits.begin(false);
  limits.tried(maximum(20.0));
  limits.tried(maximum(10.0));
  EXPECT_TRUE(limits.reason_to_stop());
  limits.helped(true);
  EXPECT_FALSE(limits.reason_to_stop());
  limits.helped(true);
  EXPECT_FALSE(limits.reason_to_stop()) << "said twice";
  limits.helped(false);
  EXPECT_TRUE(limits.reason_to_stop());
  limits.tried({});
  limits.helped(true);
  EXPECT_TRUE(limits.reason_to_stop()) << "only that of the last trial";
}

TEST(WorkLimits, AHelpedMaximumIsNoBestEither) {
  WorkLimits limits;
  limits.begin(false);
  limits.tried(maximum(30.0));
  limits.helped(true);
  limits.tried(maximum(20.0));
  EXPECT_FALSE(limits.reason_to_stop());
}

TEST(WorkLimits, AMaximumWithoutValueOrForceSaysNothing) {
  WorkLimits limits;
  limits.begin(false);
  limits.tried(maximum(0.0));
  EXPECT_FALSE(limits.reason_to_stop());
  auto none = maximum(0.0);
  none.front().value.reset();
  limits.tried(none);
  EXPECT_FALSE(limits.reason_to_stop());
}

TEST(WorkLimits, StrapsAreDueOnNumbSkinTwentyMinutesAfterTheyWereSeenLast) {
  WorkLimits numb;
  numb.begin(true);
  EXPECT_FALSE(numb.straps_due(1e6)) << "nobody is strapped";
  numb.straps_seen(100.0);
  EXPECT_FALSE(numb.straps_due(100.0 + kStrapsLookedAtEvery_s - 1.0));
  EXPECT_TRUE(numb.straps_due(100.0 + kStrapsLookedAtEvery_s));
  numb.straps_seen(1400.0);
  EXPECT_FALSE(numb.straps_due(1500.0));
  WorkLimits feeling;
  feeling.begin(false);
  feeling.straps_seen(0.0);
  EXPECT_FALSE(feeling.straps_due(1e6));
}

}  // namespace
}  // namespace isograsp::session::work_limits_test
