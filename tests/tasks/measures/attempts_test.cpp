// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/attempts.hpp"

#include <gtest/gtest.h>

namespace isograsp {
namespace {

using Forces = std::vector<double>;

TEST(Attempts, BestMeanAndTheDifferenceOfTheBestTwoDoNotDependOnTheOrder) {
  for (const Forces& attempts : {Forces{30.0, 24.0, 40.0}, Forces{40.0, 30.0, 24.0}}) {
    EXPECT_DOUBLE_EQ(best_attempt(attempts).value.value(), 40.0);
    EXPECT_NEAR(mean_of_attempts(attempts).value.value(), 94.0 / 3.0, 1e-14);
    EXPECT_DOUBLE_EQ(best_two_difference(attempts).value.value(), 25.0);
    EXPECT_FALSE(attempts_agree(attempts));
  }
  EXPECT_DOUBLE_EQ(best_two_difference(Forces{40.0, 40.0}).value.value(), 0.0);
}

TEST(Attempts, AgreeUpToTenPercentOfTheBest) {
  EXPECT_TRUE(attempts_agree(Forces{20.0, 18.0}));
  EXPECT_FALSE(attempts_agree(Forces{2.0, 5.0, 1.9})) << "only the second and third best do";
  EXPECT_FALSE(attempts_agree(Forces{20.0, 17.99}));
  EXPECT_FALSE(attempts_agree(Forces{20.0})) << "one attempt agrees with nothing";
}

TEST(Attempts, AMaximumExceededByMoreThanTenPercentWasNone) {
  EXPECT_FALSE(is_submaximal(Forces{30.0, 28.0}, 25.0));
  EXPECT_FALSE(is_submaximal(Forces{30.0, 28.0}, 33.0));
  EXPECT_TRUE(is_submaximal(Forces{30.0, 28.0}, 33.01));
  EXPECT_TRUE(is_submaximal(Forces{0.0}, 0.5));
  EXPECT_FALSE(is_submaximal({}, 5.0)) << "there was no maximum to exceed";
}

TEST(Attempts, WithoutAttemptsOrForceThereIsAReason) {
  EXPECT_FALSE(best_attempt({}).value);
  EXPECT_FALSE(mean_of_attempts({}).value);
  EXPECT_FALSE(best_two_difference(Forces{3.0}).value);
  EXPECT_EQ(best_two_difference(Forces{0.0, -1.0}).reason, "no attempt has force");
}

}  // namespace
}  // namespace isograsp
