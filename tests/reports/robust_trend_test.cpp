// SPDX-License-Identifier: GPL-3.0-or-later
// A trend does not follow single bad days, and its interval holds what it promises.
#include "statistics/robust_trend.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "reports/findings/series_trend.hpp"
#include "tests/support/within.hpp"

namespace isograsp::reports::robust_trend_test {
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
  EXPECT_WITHIN(trend.value, -0.5, kRounding);
  EXPECT_WITHIN(trend.low, -0.5, kRounding);
  EXPECT_WITHIN(trend.high, -0.5, kRounding);
}

TEST(TheilSen, AQuarterOfWildDaysDoesNotTurnIt) {
  const auto x = counting(12);
  std::vector<double> y;
  for (const double one : x) y.push_back(2.0 * one);
  for (const std::size_t wild : {2u, 7u, 11u}) y[wild] = -1000.0;
  EXPECT_WITHIN(theil_sen(x, y)->value, 2.0, kRounding);
}

TEST(TheilSen, TheIntervalFollowsDrawByDrawFromTheDocumentation) {
  // Computed by a program in another language, from docs/report.md alone.
  const std::vector<double> x{0, 0.5, 1, 2, 2.5, 4, 4.5, 6};
  const std::vector<double> y{10, 11.5, 9, 14, 12.5, 13, 17, 15.5};
  const auto trend = theil_sen(x, y).value();
  EXPECT_DOUBLE_EQ(trend.value, 1.1);
  EXPECT_DOUBLE_EQ(trend.low, 0.375);
  EXPECT_DOUBLE_EQ(trend.high, 2.25);
}

/// Every resample as docs/report.md says it, pair by pair.
Estimate slowly(const std::vector<double>& x, const std::vector<double>& y,
                const Bootstrap& bootstrap) {
  const auto n = x.size();
  const auto median_of = [](std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t lower = (values.size() - 1) / 2;
    const std::size_t upper = values.size() / 2;
    return lower == upper ? values[lower] : 0.5 * (values[lower] + values[upper]);
  };
  const auto slopes = [&](const std::vector<std::size_t>& days) {
    std::vector<double> all;
    for (std::size_t a = 0; a < days.size(); ++a)
      for (std::size_t b = a + 1; b < days.size(); ++b) {
        const auto i = std::min(days[a], days[b]);
        const auto j = std::max(days[a], days[b]);
        if (x[i] != x[j]) all.push_back((y[j] - y[i]) / (x[j] - x[i]));
      }
    return all;
  };
  std::vector<std::size_t> days(n);
  for (std::size_t i = 0; i < n; ++i) days[i] = i;
  Estimate estimate;
  estimate.value = median_of(slopes(days));
  Random random(bootstrap.seed);
  std::vector<double> medians;
  for (int k = 0; k < bootstrap.resamples; ++k) {
    for (auto& day : days)
      day = static_cast<std::size_t>(random.uniform() * static_cast<double>(n));
    if (const auto all = slopes(days); !all.empty()) medians.push_back(median_of(all));
  }
  std::sort(medians.begin(), medians.end());
  const auto tail = static_cast<std::size_t>(0.025 * static_cast<double>(medians.size()));
  estimate.low = medians[tail];
  estimate.high = medians[medians.size() - 1 - tail];
  return estimate;
}

TEST(TheilSen, IsToTheBitWhatEveryResampleByItselfGives) {
  Random random(33);
  constexpr Bootstrap kFew{100, 4};
  // The same number of days again and another seed between: what is kept of one does not stay.
  for (const int n : {5, 6, 17, 17, 40, 61, 61}) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < n; ++i) {
      x.push_back(std::floor(0.7 * i));  // some days are one
      y.push_back(std::round(4.0 * random.gaussian()) + 0.1 * i);
    }
    for (const Bootstrap& bootstrap : {kFew, Bootstrap{60, 5}, kFew}) {
      const auto fast = theil_sen(x, y, bootstrap).value();
      const auto slow = slowly(x, y, bootstrap);
      EXPECT_EQ(fast.value, slow.value) << n;
      EXPECT_EQ(fast.low, slow.low) << n;
      EXPECT_EQ(fast.high, slow.high) << n;
    }
  }
}

TEST(TheilSen, AnotherSeedChangesTheIntervalByOneHundredthOfItsWidth) {
  const auto spread = [](int resamples) {
    Random random(17);
    const auto x = counting(20);
    std::vector<double> y;
    for (const double one : x) y.push_back(-0.6 * one + 4.0 * random.gaussian());
    constexpr int kSeeds = 30;
    double squares = 0.0, sum = 0.0, width = 0.0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const auto one = theil_sen(x, y, {resamples, seed}).value();
      sum += one.low / kSeeds;
      squares += one.low * one.low / kSeeds;
      width += (one.high - one.low) / kSeeds;
    }
    return std::sqrt(squares - sum * sum) / width;
  };
  const double few = spread(400);
  const double many = spread(Bootstrap().resamples);
  std::printf("SD of the lower end over seeds, of the width: 400 resamples %.4f, as used %.4f\n",
              few, many);
  EXPECT_LT(many, 0.01);
  EXPECT_GT(few, 0.02);
}

TEST(TheilSen, DaysThatAreTiedHaveNoSlopeAndValuesThatAreNoNumbersNoTrend) {
  const std::vector<double> y{1, 2, 3, 4, 5, 6};
  EXPECT_FALSE(theil_sen(std::vector{1.0, 1.0000000000000002, 1.0, 1.0, 1.0, 1.0}, y));
  std::vector<double> huge{-1.7e308, 1.7e308, 0, 1, 2, 3};
  EXPECT_FALSE(theil_sen(counting(6), huge));
  std::vector<double> small;
  for (const double one : y) small.push_back(1e-300 * one);
  EXPECT_WITHIN(theil_sen(counting(6), small)->value / 1e-300, 1.0, 1e-9);
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
  EXPECT_WITHIN(b.value, -4.0 * a.value, 1e-9);
  EXPECT_WITHIN(b.low, -4.0 * a.high, 1e-9) << "the interval is turned over";
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
    const auto trend = theil_sen(x, y, {1000}).value();
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
  EXPECT_WITHIN(trend.tau.value, -9.0 / std::sqrt(10.0 * 9.0), kRounding);  // tau-b by hand
  EXPECT_EQ(trend.reached, 3);
  EXPECT_EQ(trend.tried, 5);
  // Only the successes get longer; with the misses it is a decline no more than an improvement.
  const std::vector back{day(0, 3.0), day(1, 4.0), day(2, 5.0), day(3, {}), day(4, {})};
  EXPECT_WITHIN(rank_trend(back)->tau.value, 9.0 / std::sqrt(10.0 * 9.0), kRounding);
}

TEST(RankTrend, TheIntervalFollowsDrawByDrawFromTheDocumentation) {
  const std::vector days{day(0, {}),  day(1, 5.0), day(2, {}), day(3, 4.0),
                         day(4, 4.0), day(5, 2.5), day(6, 3.0)};
  const auto trend = rank_trend(days).value();
  EXPECT_DOUBLE_EQ(trend.tau.value, -0.7509392614826383);
  EXPECT_DOUBLE_EQ(trend.tau.low, -1.0);
  EXPECT_DOUBLE_EQ(trend.tau.high, -0.29411764705882354);
}

TEST(RankTrend, IsNotBrokenByTheLastBit) {
  std::vector days{day(0, 12.0), day(1, 12.0), day(2, 9.0), day(3, 8.0), day(4, 12.0), day(5, {})};
  const auto whole = rank_trend(days).value();
  days[1].value = 12.000000000000002;
  days[4].value = 11.999999999999998;
  const auto broken = rank_trend(days).value();
  EXPECT_EQ(broken.tau.value, whole.tau.value);
  EXPECT_EQ(broken.tau.low, whole.tau.low);
  EXPECT_EQ(broken.tau.high, whole.tau.high);
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
  EXPECT_EQ(english(trend_words(force, sessions)), "+2\u00a0N per week (2 to 2)");
  const auto words = english(trend_words(release, sessions));
  EXPECT_EQ(words.find("reached in 6 of 10 trials, ranks \u22120.9"), 0u) << words;
}

}  // namespace
}  // namespace isograsp::reports::robust_trend_test
