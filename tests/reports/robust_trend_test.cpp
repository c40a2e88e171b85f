// SPDX-License-Identifier: GPL-3.0-or-later
// A trend does not follow single bad days, and its interval holds what it promises.
#include "reports/robust_trend.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reports/series_trend.hpp"

namespace isograsp {
namespace {

constexpr double kRounding = 1e-12;

std::vector<double> counting(int n) {
  std::vector<double> x;
  for (int i = 0; i < n; ++i) x.push_back(i);
  return x;
}

TEST(TheilSen, OfALineIsItsSlopeWithoutUncertainty) {
  const auto x = counting(8);
  std::vector<double> y;
  for (const double one : x) y.push_back(3.0 - 0.5 * one);
  const auto trend = theil_sen(x, y).value();
  EXPECT_NEAR(trend.value, -0.5, kRounding);
  EXPECT_NEAR(trend.low, -0.5, kRounding);
  EXPECT_NEAR(trend.high, -0.5, kRounding);
}

TEST(TheilSen, AQuarterOfWildDaysDoesNotTurnIt) {
  const auto x = counting(12);
  std::vector<double> y;
  for (const double one : x) y.push_back(2.0 * one);
  for (const std::size_t wild : {2u, 7u, 11u}) y[wild] = -1000.0;
  EXPECT_NEAR(theil_sen(x, y)->value, 2.0, kRounding);
}

TEST(TheilSen, FollowsUnitsAndShifts) {
  Random random(5);
  const auto x = counting(9);
  std::vector<double> y, scaled;
  for (const double one : x) {
    y.push_back(0.3 * one + random.gaussian());
    scaled.push_back(-4.0 * y.back() + 7.0);
  }
  const auto a = theil_sen(x, y).value();
  const auto b = theil_sen(x, scaled).value();
  EXPECT_NEAR(b.value, -4.0 * a.value, 1e-9);
  EXPECT_NEAR(b.low, -4.0 * a.high, 1e-9) << "the interval is turned over";
}

TEST(TheilSen, FewDaysOrOneDayHaveNone) {
  EXPECT_FALSE(theil_sen(counting(4), counting(4)));
  EXPECT_FALSE(theil_sen(std::vector(6, 1.0), counting(6)));
  EXPECT_TRUE(theil_sen(counting(5), counting(5)));
}

TEST(TheilSen, TheIntervalHoldsTheTruthAboutAsOftenAsItSays) {
  constexpr int kCourses = 400;
  constexpr double kSlope = 0.2;
  int held = 0;
  for (int course = 0; course < kCourses; ++course) {
    Random random(static_cast<std::uint64_t>(course), 3);
    const auto x = counting(15);
    std::vector<double> y;
    for (const double one : x) y.push_back(kSlope * one + random.gaussian());
    const auto trend = theil_sen(x, y).value();
    held += trend.low <= kSlope && kSlope <= trend.high ? 1 : 0;
  }
  // 95 %, less what a percentile bootstrap of 15 points is known to lack; and not everything.
  EXPECT_GE(held, kCourses * 88 / 100);
  EXPECT_LE(held, kCourses * 99 / 100);
}

CensoredDay day(double x, std::optional<double> value) {
  return {x, value, value ? 1 : 0, 1};
}

TEST(RankTrend, MissesAreTheLongestOfAll) {
  // From never to sooner and sooner: every pair agrees, but for the two misses that tie.
  const std::vector days{day(0, {}), day(1, {}), day(2, 5.0), day(3, 4.0), day(4, 3.0)};
  const auto trend = rank_trend(days).value();
  EXPECT_NEAR(trend.tau.value, -9.0 / std::sqrt(10.0 * 9.0), kRounding);  // tau-b by hand
  EXPECT_EQ(trend.reached, 3);
  EXPECT_EQ(trend.tried, 5);
  // Only the successes get longer; with the misses it is a decline no more than an improvement.
  const std::vector back{day(0, 3.0), day(1, 4.0), day(2, 5.0), day(3, {}), day(4, {})};
  EXPECT_NEAR(rank_trend(back)->tau.value, 9.0 / std::sqrt(10.0 * 9.0), kRounding);
}

TEST(RankTrend, NeedsDaysThatDiffer) {
  EXPECT_FALSE(rank_trend(std::vector{day(0, 1.0), day(1, 2.0)}));
  EXPECT_FALSE(rank_trend(std::vector(6, day(0, {}))));
}

ReportSession session(double on_day) {
  ReportSession one;
  one.day = on_day;
  return one;
}

TEST(TrendWords, OfATimeTellHowOftenItCameAndOfAllElseTheSlopePerWeek) {
  std::vector<ReportSession> sessions;
  MeasureSeries force{"maximum_force", "grip", "N", 1, true, {}, {}, "", {}, {}, "", {}, {}};
  MeasureSeries release = force;
  release.name = "release_time";
  release.unit = "s";
  for (std::size_t i = 0; i < 6; ++i) {
    sessions.push_back(session(3.5 * static_cast<double>(i)));
    force.values.push_back({i, {10.0 + static_cast<double>(i)}, 0, {}, false});
    release.values.push_back({i, {3.0 - 0.1 * static_cast<double>(i)}, i < 2 ? 2 : 0, {}, false});
  }
  EXPECT_EQ(trend_words(force, sessions), "+2\u00a0N per week (2 to 2)");
  const auto words = trend_words(release, sessions);
  EXPECT_EQ(words.find("reached in 6 of 10 trials, ranks \u22120.9"), 0u) << words;
}

}  // namespace
}  // namespace isograsp
