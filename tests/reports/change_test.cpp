// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas of a verdict, by hand.
#include "reports/findings/change.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "statistics/robust_variance.hpp"
#include "tests/support/normal.hpp"
#include "tests/support/within.hpp"

namespace isograsp::reports::change_test {
namespace {

/// Single operations of doubles, and a quantile to some ulp.
constexpr double kRounding = 1e-12;
/// All pairs of a pool alike: none is left out, the consistency factors remain. Ten pairs of days,
/// twenty of trials.
const double kDaySd =
    1.0 / std::sqrt(statistics::kUnequalVariances.kept * statistics::small_sample_share(10.0));
const double kTrialSd =
    1.0 / std::sqrt(statistics::kOneVariance.kept * statistics::small_sample_share(20.0));

AssessmentDay day(double number, std::vector<double> trials) {
  return {number, std::move(trials), false};
}
AssessmentDay failed_day(double number) {
  return {number, {1.0}, true};
}

StablePool pool_of(const std::vector<StableDays>& stable) {
  return reports::pool_of(stable, ErrorScale::linear);
}

/// `people` persons with one pair each: `level` and `level + difference`.
std::vector<StableDays> alike(int people, double level, double difference, int gap_days = 3) {
  std::vector<StableDays> all;
  for (int person = 0; person < people; ++person)
    all.push_back({person, {day(0, {level}), day(gap_days, {level + difference})}});
  return all;
}

TEST(Pool, NeedsTenPeopleWithAPair) {
  auto nine = alike(9, 10.0, 1.0);
  nine.push_back({0, {day(20, {10.0}), day(21, {11.0})}});  // one of the nine once more
  const auto too_small = pool_of(nine);
  EXPECT_EQ(too_small.people, 9);
  EXPECT_EQ(too_small.pairs, 10);
  EXPECT_FALSE(too_small.error.has_value());
  EXPECT_TRUE(pool_of(alike(10, 10.0, 1.0)).error.has_value());
}

TEST(Pool, TakesPairsOneToSevenDaysApartAndNoDayTwice) {
  EXPECT_EQ(pool_of(alike(10, 10.0, 1.0, 0)).pairs, 0);
  EXPECT_EQ(pool_of(alike(10, 10.0, 1.0, 1)).pairs, 10);
  EXPECT_EQ(pool_of(alike(10, 10.0, 1.0, 7)).pairs, 10);
  EXPECT_EQ(pool_of(alike(10, 10.0, 1.0, 8)).pairs, 0);
  const std::vector<StableDays> five{
      {1, {day(0, {1}), day(3, {2}), day(6, {1}), day(20, {2}), day(22, {1})}}};
  EXPECT_EQ(pool_of(five).pairs, 2);  // 0-3, 20-22
  const std::vector<StableDays> failing{{1, {day(0, {1}), failed_day(3)}}};
  EXPECT_EQ(pool_of(failing).people, 0);
}

TEST(Pool, HalfTheSquareOfADifferenceIsTheVarianceOfADay) {
  auto stable = alike(10, 10.0, 0.6);
  for (auto& one : stable) one.days[0].trials = {0.0};  // no logarithm
  for (auto& one : stable) one.days[1].trials = {0.6};
  const auto error = *pool_of(stable).error;
  EXPECT_EQ(error.scale, ErrorScale::linear);
  EXPECT_WITHIN(error.day_sd, kDaySd * 0.6 / std::sqrt(2.0), kRounding);
  EXPECT_EQ(error.trial_sd, 0.0);
}

TEST(Pool, APersonWithManyPairsWeighsAsMuchAsOneWithASingle) {
  auto stable = alike(9, -10.0, 0.0);
  StableDays many{9, {}};
  for (int i = 0; i < 10; ++i) many.days.push_back(day(2 * i, {i % 2 == 0 ? -10.0 : -8.0}));
  stable.push_back(many);
  const auto pool = pool_of(stable);
  EXPECT_EQ(pool.pairs, 9 + 5);
  EXPECT_WITHIN(pool.error->day_sd, std::sqrt(2.0 / 10.0), kRounding);  // 2^2 / 2 of one in ten
}

TEST(Pool, WhatTheTrialsExplainIsNoVariationOfDays) {
  std::vector<StableDays> stable;
  for (int person = 0; person < 10; ++person)
    stable.push_back({person, {day(0, {-1.0, 1.0}), day(2, {2.0, 4.0})}});
  const auto error = *pool_of(stable).error;
  EXPECT_WITHIN(error.trial_sd, kTrialSd * std::sqrt(2.0), kRounding);
  EXPECT_WITHIN(error.day_sd,
                std::sqrt(kDaySd * kDaySd * 3.0 * 3.0 / 2.0 - kTrialSd * kTrialSd * 2.0 / 2.0),
                kRounding);
}

TEST(Pool, IsLogarithmicWhereTheErrorClearlyGrowsWithTheMean) {
  std::vector<StableDays> growing;
  std::vector<StableDays> constant;
  for (int person = 0; person < 10; ++person) {
    const double level = 2.0 * std::pow(1.35, person);  // 2 to 30
    const double sign = person % 2 == 0 ? 1.0 : -1.0;
    growing.push_back({person, {day(0, {level}), day(3, {level * (1.0 + 0.2 * sign)})}});
    constant.push_back({person, {day(0, {level}), day(3, {level + 0.5 * sign})}});
  }
  const auto scale = [](const std::vector<StableDays>& stable, ErrorScale usual) {
    return reports::pool_of(stable, usual).error->scale;
  };
  for (const auto usual : {ErrorScale::linear, ErrorScale::logarithmic}) {
    EXPECT_EQ(scale(growing, usual), ErrorScale::logarithmic);
    EXPECT_EQ(scale(constant, usual), ErrorScale::linear);
    EXPECT_EQ(scale(alike(10, 10.0, 1.0), usual), usual) << "alike people do not tell";
  }
  growing[3].days[0].trials = {0.0};
  EXPECT_EQ(scale(growing, ErrorScale::logarithmic), ErrorScale::logarithmic)
      << "one outlying day in ten pairs";
  growing[4].days[0].trials = {-0.1};
  EXPECT_EQ(scale(growing, ErrorScale::logarithmic), ErrorScale::linear) << "no logarithms";
}

TEST(Pool, WithoutAnyVariationKnowsNoError) {
  const auto pool = pool_of(alike(12, 5.0, 0.0));
  EXPECT_EQ(pool.people, 12);
  EXPECT_FALSE(pool.error.has_value());
}

TEST(Pool, TheDegreesOfFreedomAreThoseOfAPersonOutsideThePool) {
  // v = (31 / 50000) / (7 / 300)^2 - 1, df = 2 / (v + (v + 2 (1 + v) / 0.7) / n)
  const double v = 31.0 / 50000.0 / (7.0 / 300.0 * 7.0 / 300.0) - 1.0;
  for (const int n : {10, 25, 400})
    EXPECT_WITHIN(pool_of(alike(n, 10.0, 1.0)).error->df,
                  2.0 / (v + (v + 2.0 * (1.0 + v) / 0.7) / n), 1e-9);
  EXPECT_LT(pool_of(alike(4000, 10.0, 1.0)).error->df, 2.0 / v);
  // As docs/change.md says them, to their last digit.
  EXPECT_NEAR(pool_of(alike(10, 10.0, 1.0)).error->df, 4.2, 0.05);
  EXPECT_NEAR(pool_of(alike(30, 10.0, 1.0)).error->df, 7.9, 0.05);
  EXPECT_NEAR(2.0 / v, 14.4, 0.05);
}

/// Ten people whose days differ by about `difference`.
std::vector<StableDays> ordinary(double level, double difference) {
  auto all = alike(10, level, 0.0);
  for (auto& one : all) {
    const double size = difference * (0.6 + 0.08 * static_cast<double>(one.person));
    one.days[1].trials = {level + (one.person % 2 == 0 ? size : -size)};
  }
  return all;
}

TEST(Pool, OneOutlyingDayDoesNotMakeTheErrorUselessForEverybody) {
  for (const auto scale : {ErrorScale::linear, ErrorScale::logarithmic}) {
    auto stable = ordinary(20.0, 1.5);
    const auto before = reports::pool_of(stable, scale);
    for (const double wild : {1.0, 0.0, -0.1, 1000.0}) {
      stable[4].days[1].trials = {wild};
      const auto after = reports::pool_of(stable, scale);
      EXPECT_EQ(after.people, 10);
      EXPECT_EQ(after.left_out, 1);
      EXPECT_EQ(after.error->scale, scale);
      EXPECT_NEAR(after.error->day_sd / before.error->day_sd, 1.0, 0.05) << wild;
    }
  }
}

TEST(Pool, OneOutlyingTrialDoesNotMakeItUselessEither) {
  auto stable = ordinary(20.0, 1.5);
  for (auto& one : stable)
    for (auto& day : one.days) day.trials = {day.trials[0] - 0.2, day.trials[0] + 0.2};
  const auto before = pool_of(stable);
  stable[4].days[1].trials = {20.0, 400.0};
  const auto after = pool_of(stable);
  const auto mdc = [](const StablePool& pool) { return mdc95(*pool.error, {2, 4.0}, {1, 2.0}); };
  EXPECT_NEAR(mdc(after) / mdc(before), 1.0, 0.05);
}

TEST(Pool, WhereHalfOfThePairsDoNotDifferNothingTellsWhichIsOutlying) {
  auto stable = alike(10, 5.0, 0.0);
  for (std::size_t i = 0; i < 3; ++i) stable[i].days[1].trials = {6.0};
  const auto pool = pool_of(stable);
  EXPECT_EQ(pool.left_out, 0);
  EXPECT_WITHIN(pool.error->day_sd, std::sqrt(3.0 / 2.0 / 10.0), kRounding);
}

TEST(Pool, KnowsNoUnit) {
  const auto error = *pool_of(ordinary(20.0, 1.5)).error;
  for (const double unit : {1e-300, 1e160, 1e300}) {
    auto stable = ordinary(20.0, 1.5);
    for (auto& one : stable)
      for (auto& day : one.days)
        for (auto& value : day.trials) value *= unit;
    const auto scaled = pool_of(stable);
    ASSERT_TRUE(scaled.error) << unit;
    EXPECT_WITHIN(scaled.error->day_sd / unit / error.day_sd, 1.0, 1e-9) << unit;
    EXPECT_WITHIN(
        mdc95(*scaled.error, {2, 2.0}, {1, 1.0}) / unit / mdc95(error, {2, 2.0}, {1, 1.0}), 1.0,
        1e-9);
  }
}

TEST(RobustSd, HasTheConsistencyOfItsDistribution) {
  // Median of (a - b)^2 / 2 and mean of what lies within three SDs, in units of the mean variance:
  // of normal values, and of normal values whose SDs lie evenly between 1 and 2.
  const auto share_below = [](double z) { return std::erf(z / std::sqrt(2.0)); };
  const auto squares_below = [&](double z) {
    return share_below(z) - z * std::sqrt(2.0 / M_PI) * std::exp(-z * z / 2.0);
  };
  const auto check = [&](double least, double most, const statistics::Consistency& is) {
    constexpr int kSteps = 20000;
    double median = 0.0, kept = 0.0, squares = 0.0;
    const double mean_square = (least * least + least * most + most * most) / 3.0;
    for (int i = 0; i < kSteps; ++i) {
      const double sd = std::lerp(least, most, (i + 0.5) / kSteps) / std::sqrt(mean_square);
      median += share_below(std::sqrt(is.median) / sd) / kSteps;
      kept += share_below(statistics::kKeptSds / sd) / kSteps;
      squares += sd * sd * squares_below(statistics::kKeptSds / sd) / kSteps;
    }
    EXPECT_WITHIN(median, 0.5, 1e-7);
    EXPECT_WITHIN(squares / kept, is.kept, 1e-7);
  };
  check(1.0, 1.0, statistics::kOneVariance);
  check(1.0, 2.0, statistics::kUnequalVariances);
}

/// Mean of the variances that pairs of `people` give, each with `pairs` of them; the true one is 1.
/// `least`: smallest SD, in units of the largest.
double mean_variance(int people, int pairs, double least,
                     const statistics::Consistency& consistency) {
  constexpr int kDraws = 40000;
  const double mean_square = (1.0 + least + least * least) / 3.0;
  Random random(61, static_cast<std::uint64_t>(100 * people + pairs));
  double sum = 0.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<statistics::PairDifference> all;
    for (int person = 0; person < people; ++person) {
      const double sd = std::lerp(least, 1.0, random.uniform()) / std::sqrt(mean_square);
      for (int pair = 0; pair < pairs; ++pair)
        all.push_back({std::sqrt(2.0) * sd * test::normal(random), 1.0 / pairs});
    }
    const double found = statistics::robust_sd(all, consistency, 0.0).sd;
    sum += found * found / kDraws;
  }
  return sum;
}

TEST(RobustSd, IsRightOnAverageForFewPairs) {
  constexpr double kWithin = 0.01;
  constexpr double kThreeStandardErrors = 0.009;  // of 40,000 draws of relative variance 3 / 10
  for (const int people : {10, 11, 15, 20, 50}) {
    EXPECT_NEAR(mean_variance(people, 1, 0.5, statistics::kUnequalVariances), 1.0,
                kWithin + kThreeStandardErrors)
        << people;
    EXPECT_NEAR(mean_variance(people, 1, 1.0, statistics::kOneVariance), 1.0,
                kWithin + kThreeStandardErrors)
        << people;
  }
  EXPECT_NEAR(mean_variance(10, 4, 0.5, statistics::kUnequalVariances), 1.0,
              kWithin + kThreeStandardErrors);
  EXPECT_LT(mean_variance(11, 1, 0.5, statistics::kUnequalVariances) *
                statistics::small_sample_share(11.0),
            0.98)
      << "without the correction";
}

TEST(Mdc95, IsTheFormula) {
  MeasurementError error{ErrorScale::linear, 3.0, 4.0, 10.0, 2.0};
  // 2 sqrt(9 (1/2 + 1/1) + 16 (1/4 + 1/2))
  EXPECT_WITHIN(mdc95(error, {2, 4.0}, {1, 2.0}), 2.0 * std::sqrt(13.5 + 12.0), kRounding);
  const auto pool = pool_of(alike(10, -10.0, 1.0));
  EXPECT_GT(pool.error->t975, 2.571) << "t table, at 5 degrees of freedom";
  EXPECT_LT(pool.error->t975, 2.776) << "at 4";
}

/// A pool whose MDC of one day against two is exactly 1, for one trial a day.
StablePool unit_pool(ErrorScale scale = ErrorScale::linear) {
  return {10, 10, MeasurementError{scale, 1.0 / std::sqrt(1.5), 0.0, 10.0, 1.0}};
}

std::vector<AssessmentDay> course(const std::vector<double>& means) {
  std::vector<AssessmentDay> days;
  for (const double mean : means) days.push_back(day(static_cast<double>(days.size()), {mean}));
  return days;
}
ChangeJudgement judged(const std::vector<double>& means,
                       tasks::Better better = tasks::Better::higher,
                       const StablePool& pool = unit_pool()) {
  return judge_change(course(means), pool, better);
}

TEST(Judge, MeansAndChangesNearTheLargestNumberAreNumbersOrNone) {
  const double huge = 1.7e308;
  EXPECT_EQ(day_mean(day(0, {huge, huge, huge})), huge);
  EXPECT_EQ(mean_of(course({huge, huge})), huge);
  const auto up =
      judge_change(course({-huge, -huge, huge, huge}), unit_pool(), tasks::Better::higher);
  EXPECT_EQ(up.baseline, -huge);
  EXPECT_FALSE(up.change) << "too large for a number";
  EXPECT_EQ(up.verdict, Verdict::improved);
  EXPECT_TRUE(up.confirmed);
}

TEST(Judge, TheBaselineIsTheMeanOfTwoDays) {
  const auto one = judge_change(std::vector{day(0, {9.0, 11.0}), day(4, {12.0}), day(9, {11.5})},
                                unit_pool(), tasks::Better::higher);
  EXPECT_DOUBLE_EQ(*one.baseline, 11.0);
  EXPECT_DOUBLE_EQ(*one.last, 11.5);
  EXPECT_DOUBLE_EQ(*one.change, 0.5);
  EXPECT_EQ(one.verdict, Verdict::within_error);
}

TEST(Judge, BeyondTheErrorOnceIsPossibleTwiceInARowConfirmed) {
  EXPECT_EQ(judged({10, 10, 10.99}).verdict, Verdict::within_error);
  const auto first = judged({10, 10, 11.01});
  EXPECT_EQ(first.verdict, Verdict::improved);
  EXPECT_FALSE(first.confirmed);
  const auto second = judged({10, 10, 11.01, 11.5});
  EXPECT_EQ(second.verdict, Verdict::improved);
  EXPECT_TRUE(second.confirmed);
  EXPECT_FALSE(judged({10, 10, 11.01, 10.5, 11.5}).confirmed) << "not in a row";
  EXPECT_FALSE(judged({10, 10, 8.5, 11.5}).confirmed) << "not in the same direction";
  EXPECT_EQ(judged({10, 10, 12, 12, 10.5}).verdict, Verdict::within_error) << "it is gone again";
}

TEST(Judge, TheDirectionOfTheMeasureSaysWhatIsBetter) {
  EXPECT_EQ(judged({10, 10, 8.5}, tasks::Better::higher).verdict, Verdict::worsened);
  EXPECT_EQ(judged({10, 10, 8.5}, tasks::Better::lower).verdict, Verdict::improved);
  EXPECT_EQ(judged({-3, -3, -1.5}, tasks::Better::near_zero).verdict, Verdict::improved);
  EXPECT_EQ(judged({-3, -3, 3.5}, tasks::Better::near_zero).verdict, Verdict::within_error);
  EXPECT_EQ(judged({-3, -3, 4.5}, tasks::Better::near_zero).verdict, Verdict::worsened);
  EXPECT_EQ(judged({10, 10, 8}, tasks::Better::unknown).why, WhyNotJudged::no_direction);
}

TEST(Judge, SaysWhereTheWholeWayToZeroIsWithinTheError) {
  EXPECT_TRUE(judged({1, 0.9, 5}).none_to_zero);
  EXPECT_FALSE(judged({1, 1.1, 5}).none_to_zero);
  EXPECT_FALSE(
      judged({0.1, 0.1, 5}, tasks::Better::higher, unit_pool(ErrorScale::logarithmic)).none_to_zero)
      << "a share of the baseline never reaches it";
}

TEST(Judge, OnLogarithmsTheErrorIsAShareOfTheBaseline) {
  const auto one = judged({10, 10, 26}, tasks::Better::higher, unit_pool(ErrorScale::logarithmic));
  EXPECT_EQ(one.verdict, Verdict::within_error);  // log 2.6 < 1
  EXPECT_WITHIN(*one.mdc_up, 10.0 * (std::exp(1.0) - 1.0), 1e-9);
  EXPECT_WITHIN(*one.mdc_down, 10.0 * (std::exp(-1.0) - 1.0), 1e-9);
  EXPECT_EQ(judged({10, 10, 28}, tasks::Better::higher, unit_pool(ErrorScale::logarithmic)).verdict,
            Verdict::improved);
}

TEST(Judge, OnLogarithmsAValueThatIsNotPositiveIsBelowEveryLimit) {
  const auto log = unit_pool(ErrorScale::logarithmic);
  const auto lost = judged({10, 10, 0}, tasks::Better::higher, log);
  EXPECT_EQ(lost.verdict, Verdict::worsened);
  EXPECT_FALSE(lost.confirmed);
  const auto lost_twice = judged({10, 10, 0, 0}, tasks::Better::higher, log);
  EXPECT_EQ(lost_twice.verdict, Verdict::worsened);
  EXPECT_TRUE(lost_twice.confirmed);
  EXPECT_TRUE(judged({10, 10, -0.1, 0.5}, tasks::Better::higher, log).confirmed);
  EXPECT_EQ(judged({10, 10, -0.5}, tasks::Better::lower, log).verdict, Verdict::improved);
  EXPECT_EQ(judged({0, 0, 10}, tasks::Better::higher, log).why, WhyNotJudged::not_positive);
  EXPECT_EQ(judged({-1, 0.5, 10}, tasks::Better::higher, log).why, WhyNotJudged::not_positive);
}

TEST(Judge, TheBaselineIsTheFirstTwoDaysWithAMean) {
  const AssessmentDay empty{0, {}, false};
  for (const auto& lost : {failed_day(0), empty}) {
    const auto one =
        judge_change(std::vector{lost, day(1, {10.0}), lost, day(3, {12.0}), day(4, {11.5})},
                     unit_pool(), tasks::Better::higher);
    EXPECT_EQ(one.baseline, 11.0);
    EXPECT_EQ(one.verdict, Verdict::within_error);
    EXPECT_EQ(judge_change(std::vector{lost, day(1, {10.0}), day(2, {10.0})}, unit_pool(),
                           tasks::Better::higher)
                  .why,
              WhyNotJudged::nothing_after);
  }
  const auto twice = judge_change(
      std::vector{failed_day(0), day(1, {10}), day(2, {10}), day(3, {12}), day(4, {12})},
      unit_pool(), tasks::Better::higher);
  EXPECT_TRUE(twice.confirmed);
  const auto once =
      judge_change(std::vector{day(0, {10}), failed_day(1), day(2, {12}), day(3, {14})},
                   unit_pool(), tasks::Better::higher);
  EXPECT_FALSE(once.confirmed) << "the day before belongs to the baseline";
}

TEST(Judge, SaysWhyItCannot) {
  EXPECT_EQ(judged({10}).why, WhyNotJudged::baseline_too_short);
  EXPECT_EQ(judged({10, 10}).why, WhyNotJudged::nothing_after);
  EXPECT_EQ(judged({10, 10, 20}, tasks::Better::higher, {9, 9, {}}).why,
            WhyNotJudged::too_few_people);
  EXPECT_EQ(judged({10, 10, 20}, tasks::Better::higher, {10, 10, {}}).why,
            WhyNotJudged::no_variation);
  const auto judge = [](std::vector<AssessmentDay> days) {
    return judge_change(days, unit_pool(), tasks::Better::higher);
  };
  EXPECT_EQ(judge({failed_day(0), day(1, {1})}).why, WhyNotJudged::baseline_failed);
  EXPECT_EQ(judge({day(0, {1}), day(1, {1}), failed_day(2)}).why, WhyNotJudged::last_failed);
  const auto after_failure =
      judge({day(0, {1}), day(1, {1}), day(2, {9}), failed_day(3), day(4, {9})});
  EXPECT_EQ(after_failure.verdict, Verdict::improved);
  EXPECT_FALSE(after_failure.confirmed) << "the day between is not known";
}

TEST(Judge, MoreTrialsMakeSmallerErrorsAndUnequalDaysDoNotPretendToHaveMore) {
  StablePool pool{10, 10, MeasurementError{ErrorScale::linear, 0.0, 1.0, 10.0, 1.0}};
  const auto mdc = [&](std::vector<AssessmentDay> days) {
    return *judge_change(days, pool, tasks::Better::higher).mdc_up;
  };
  const double single = mdc({day(0, {1}), day(1, {1}), day(2, {1})});
  const double twice = mdc({day(0, {1, 1}), day(1, {1, 1}), day(2, {1, 1})});
  const double uneven = mdc({day(0, {1}), day(1, {1, 1, 1}), day(2, {1, 1})});
  EXPECT_WITHIN(single, std::sqrt(1.5), kRounding);
  EXPECT_WITHIN(twice, std::sqrt(0.75), kRounding);
  EXPECT_WITHIN(uneven, std::sqrt((1.0 + 1.0 / 3.0) / 4.0 + 0.5), kRounding);
}

}  // namespace
}  // namespace isograsp::reports::change_test
