// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/attempts.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace isograsp::tasks::attempts_test {
namespace {

using Forces = std::vector<double>;
constexpr double kPercent = 10.0;

TEST(Attempts, TheBestTwoAgreeInAnyOrderUpToAShareOfTheLarger) {
  for (const Forces& attempts : {Forces{20.0, 18.0, 3.0}, Forces{3.0, 20.0, 18.0}})
    EXPECT_TRUE(attempts_agree(attempts, kPercent, Compared::best_two));
  EXPECT_FALSE(attempts_agree(Forces{20.0, 17.99}, kPercent, Compared::best_two));
  EXPECT_FALSE(attempts_agree(Forces{2.0, 5.0, 1.9}, kPercent, Compared::best_two))
      << "only the second and third best do";
  EXPECT_TRUE(attempts_agree(Forces{20.0, 17.99}, 2.0 * kPercent, Compared::best_two));
}

TEST(Attempts, InPracticeTheLastTwoAreCompared) {
  const Forces warming_up{5.0, 20.0, 20.5, 9.0};
  EXPECT_TRUE(attempts_agree(warming_up, kPercent, Compared::best_two));
  EXPECT_FALSE(attempts_agree(warming_up, kPercent, Compared::last_two));
  EXPECT_TRUE(attempts_agree(Forces{20.0, 9.0, 9.5}, kPercent, Compared::last_two));
  EXPECT_TRUE(attempts_agree(Forces{-9.0, -9.5}, kPercent, Compared::last_two))
      << "a constant error may be negative";
}

TEST(Attempts, OneAttemptAgreesWithNothing) {
  for (const Compared compared : {Compared::best_two, Compared::last_two}) {
    EXPECT_FALSE(attempts_agree({}, kPercent, compared));
    EXPECT_FALSE(attempts_agree(Forces{20.0}, kPercent, compared));
  }
}

}  // namespace
}  // namespace isograsp::tasks::attempts_test
