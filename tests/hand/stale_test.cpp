// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/stale.hpp"

#include <gtest/gtest.h>

namespace isograsp::stale_test {
namespace {

using Verdict = StaleRule::Verdict;
constexpr std::array<bool, 3> kAll{true, true, true};
constexpr std::array<bool, 3> kNoThumb{false, true, true};

TEST(StaleRule, HoldsTheLastForceForExactlyFiftyMillisecondsAtEveryRate) {
  for (const double rate_Hz : {50.0, 100.0, 120.0, 250.0, 500.0, 1000.0}) {
    StaleRule rule;
    FingerWrenches wrench{};
    wrench[0].force.z() = 4.0;
    EXPECT_EQ(rule.apply(wrench, kAll, kAll, 1.0 / rate_Hz), Verdict::fresh);
    int held = 0;
    for (;; ++held) {
      FingerWrenches empty{};
      if (rule.apply(empty, kNoThumb, kAll, 1.0 / rate_Hz) == Verdict::frozen) break;
      EXPECT_EQ(empty[0].force.z(), 4.0);
      EXPECT_TRUE(rule.held(0));
    }
    EXPECT_EQ(held, static_cast<int>(rate_Hz * kLongestHold_s + 1e-9)) << rate_Hz;
  }
}

TEST(StaleRule, NothingIsInventedBeforeTheFirstSampleAndUnusedFingersDoNotMatter) {
  StaleRule rule;
  FingerWrenches wrench{};
  EXPECT_EQ(rule.apply(wrench, kNoThumb, kAll, 0.01), Verdict::frozen);
  EXPECT_EQ(rule.apply(wrench, kNoThumb, kNoThumb, 0.01), Verdict::fresh);
}

TEST(StaleRule, AFreshSampleEndsTheFreeze) {
  StaleRule rule;
  FingerWrenches wrench{};
  (void)rule.apply(wrench, kAll, kAll, 0.01);
  for (int i = 0; i < 10; ++i) (void)rule.apply(wrench, kNoThumb, kAll, 0.01);
  EXPECT_EQ(rule.apply(wrench, kNoThumb, kAll, 0.01), Verdict::frozen);
  EXPECT_EQ(rule.apply(wrench, kAll, kAll, 0.01), Verdict::fresh);
}

}  // namespace
}  // namespace isograsp::stale_test
