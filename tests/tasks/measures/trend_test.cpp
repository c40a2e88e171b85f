// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/trend.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace isograsp {
namespace {

constexpr double kRounding = 1e-12;

TEST(Trend, TheDataOfSenHaveTheirPublishedSlopeAndTheRanksOfKendallsTable) {
  const std::vector<double> x{1, 2, 3, 4, 10, 12, 18};
  const std::vector<double> y{9, 15, 19, 20, 45, 55, 78};
  struct Case {
    double confidence;
    double lower;
    double upper;
  };
  // Of 7 points: P(S >= 13) = 0.0345, P(S >= 15) = 0.0151. Hence the 5th slope from either end for
  // 93 %, the 4th for 95 %.
  for (const Case& c : {Case{0.93, 15.0 / 4.0, 46.0 / 11.0}, Case{0.95, 26.0 / 7.0, 35.0 / 8.0}}) {
    const auto trend = theil_sen(x, y, c.confidence);
    ASSERT_TRUE(trend && trend->interval);
    EXPECT_NEAR(trend->slope, 4.0, kRounding);
    EXPECT_NEAR(trend->intercept, 4.0, kRounding);
    EXPECT_NEAR(trend->interval->lower, c.lower, kRounding);
    EXPECT_NEAR(trend->interval->upper, c.upper, kRounding);
  }
}

TEST(Trend, AQuarterOfWildPointsHardlyMovesIt) {
  std::vector<double> x;
  std::vector<double> y;
  for (int k = 0; k < 20; ++k) {
    x.push_back(k);
    y.push_back(k % 4 == 3 ? 1000.0 : 5.0 - 2.0 * k);
  }
  const auto trend = theil_sen(x, y);
  ASSERT_TRUE(trend);
  EXPECT_NEAR(trend->slope, -2.0, kRounding);
}

TEST(Trend, UnitsOriginAndOrderOfThePointsDoNotMatter) {
  const std::vector<double> x{1, 2, 3, 4, 10, 12, 18};
  const std::vector<double> y{9, 15, 19, 20, 45, 55, 78};
  auto other_x = x;
  auto other_y = y;
  for (double& value : other_x) value = 7.0 + 4.0 * value;
  for (double& value : other_y) value = -3.0 - 2.0 * value;
  std::swap(other_x[0], other_x[5]);
  std::swap(other_y[0], other_y[5]);
  const auto trend = theil_sen(x, y);
  const auto other = theil_sen(other_x, other_y);
  ASSERT_TRUE(trend && other && trend->interval && other->interval);
  EXPECT_NEAR(other->slope, -0.5 * trend->slope, kRounding);
  EXPECT_NEAR(other->interval->lower, -0.5 * trend->interval->upper, kRounding);
  EXPECT_NEAR(other->interval->upper, -0.5 * trend->interval->lower, kRounding);
}

/// Share of trials in which the interval holds the true slope, 0.7.
double coverage(int points, bool ties) {
  Random random(points + (ties ? 1000 : 0), 0);
  constexpr int kTrials = 2000;
  int covered = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> x;
    std::vector<double> y;
    for (int k = 0; k < points; ++k) {
      x.push_back(ties ? k / 2 : k);
      y.push_back(0.7 * x.back() + random.gaussian());
    }
    const auto trend = theil_sen(x, y);
    if (trend->interval->lower <= 0.7 && 0.7 <= trend->interval->upper) ++covered;
  }
  return static_cast<double>(covered) / kTrials;
}

TEST(Trend, TheIntervalHoldsTheTrueSlopeAsOftenAsItSays) {
  constexpr double kFourStandardErrors = 0.02;  // of a share of 0.95 in 2000 trials
  for (const int points : {6, 10, 20})
    EXPECT_GE(coverage(points, false), 0.95 - kFourStandardErrors);
  EXPECT_NEAR(coverage(20, false), 0.95, kFourStandardErrors);
  EXPECT_NEAR(coverage(60, false), 0.95, kFourStandardErrors) << "normal approximation";
  EXPECT_NEAR(coverage(24, true), 0.95, kFourStandardErrors) << "ties in x";
}

TEST(Trend, TooFewPointsHaveNoIntervalAndOneNoSlope) {
  const std::vector<double> x{1, 2, 3, 4, 5};
  const std::vector<double> y{1, 3, 2, 5, 4};
  const auto four = theil_sen(std::span(x).first(4), std::span(y).first(4));
  ASSERT_TRUE(four);
  EXPECT_FALSE(four->interval) << "even the extreme orders of four have probability 1/12";
  EXPECT_TRUE(theil_sen(x, y)->interval);
  EXPECT_FALSE(theil_sen(std::span(x).first(1), std::span(y).first(1)));
  EXPECT_FALSE(theil_sen(std::vector<double>{2, 2}, std::vector<double>{1, 3}));
}

}  // namespace
}  // namespace isograsp
