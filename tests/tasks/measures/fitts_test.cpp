// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/fitts.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::tasks::fitts_test {
namespace {

constexpr double kRounding = 1e-12;

/// Ends at +-error round the centre: SD (n - 1) = error sqrt(n / (n - 1)).
std::vector<AimedTrial> trials_of(int count, double distance, double error, double time_s) {
  std::vector<AimedTrial> trials;
  for (int k = 0; k < count; ++k)
    trials.push_back({distance, 0.1 + (k % 2 == 0 ? error : -error), time_s + 0.1 * (k % 2)});
  return trials;
}

TEST(Fitts, DifficultyIsTheLogarithmOfDistanceOverWidthPlusOne) {
  EXPECT_WITHIN(index_of_difficulty(7.0, 0.5).value.value(), 3.0, kRounding);
  EXPECT_WITHIN(index_of_difficulty(0.0, 0.5).value.value(), 0.0, kRounding);
  EXPECT_WITHIN(index_of_difficulty(30.0, 1.0).value.value(), 4.0, kRounding);
  EXPECT_FALSE(index_of_difficulty(7.0, 0.0).value);
  EXPECT_FALSE(index_of_difficulty(-1.0, 0.5).value);
}

TEST(Fitts, EffectiveWidthIsThatOfTheEndPointsNotOfTheirBias) {
  const double sd = 0.4 * std::sqrt(10.0 / 9.0);
  const double width = effective_width(trials_of(10, 8.0, 0.4, 1.0)).value.value();
  EXPECT_WITHIN(width, 4.133 * sd, kRounding);
  // The constant is that of equal entropy.
  EXPECT_WITHIN(width / sd, std::sqrt(2.0 * std::numbers::pi * std::numbers::e), 0.5e-3);
}

TEST(Fitts, ThroughputIsDifficultyPerMeanTimeAndBlindToTheUnitOfDistance) {
  const auto trials = trials_of(20, 8.0, 0.4, 1.0);
  const double width = 4.133 * 0.4 * std::sqrt(20.0 / 19.0);
  EXPECT_WITHIN(throughput(trials).value.value(), std::log2(8.0 / width + 1.0) / 1.05, kRounding);
  auto larger = trials;
  for (AimedTrial& trial : larger) {
    trial.distance *= 1000.0;
    trial.error *= 1000.0;
  }
  EXPECT_WITHIN(throughput(larger).value.value(), throughput(trials).value.value(), kRounding);
}

TEST(Fitts, TooFewOrIdenticalTrialsHaveAReason) {
  EXPECT_EQ(english(throughput(trials_of(9, 8.0, 0.4, 1.0)).reason), "fewer than ten trials");
  EXPECT_EQ(english(throughput(trials_of(10, 8.0, 0.0, 1.0)).reason), "the end points do not vary");
  EXPECT_EQ(english(throughput(trials_of(10, 0.0, 0.4, 1.0)).reason), "nothing moved");
}

}  // namespace
}  // namespace isograsp::tasks::fitts_test
