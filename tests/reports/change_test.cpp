// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas of a verdict, by hand.
#include "reports/change.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace isograsp {
namespace {

/// Single operations of doubles, and a quantile to some ulp.
constexpr double kRounding = 1e-12;

AssessmentDay day(double number, std::vector<double> trials) {
  return {number, std::move(trials), false};
}
AssessmentDay failed_day(double number) {
  return {number, {1.0}, true};
}

StablePool pool_of(const std::vector<StableDays>& stable) {
  return isograsp::pool_of(stable, ErrorScale::linear);
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
  EXPECT_NEAR(error.day_sd, 0.6 / std::sqrt(2.0), kRounding);
  EXPECT_EQ(error.trial_sd, 0.0);
}

TEST(Pool, APersonWithManyPairsWeighsAsMuchAsOneWithASingle) {
  auto stable = alike(9, -10.0, 0.0);
  StableDays many{9, {}};
  for (int i = 0; i < 10; ++i) many.days.push_back(day(2 * i, {i % 2 == 0 ? -10.0 : -8.0}));
  stable.push_back(many);
  const auto pool = pool_of(stable);
  EXPECT_EQ(pool.pairs, 9 + 5);
  EXPECT_NEAR(pool.error->day_sd, std::sqrt(2.0 / 10.0), kRounding);  // 2^2 / 2 of one in ten
}

TEST(Pool, WhatTheTrialsExplainIsNoVariationOfDays) {
  std::vector<StableDays> stable;
  for (int person = 0; person < 10; ++person)
    stable.push_back({person, {day(0, {-1.0, 1.0}), day(2, {2.0, 4.0})}});
  const auto error = *pool_of(stable).error;
  EXPECT_NEAR(error.trial_sd, std::sqrt(2.0), kRounding);
  EXPECT_NEAR(error.day_sd, std::sqrt(3.0 * 3.0 / 2.0 - 2.0 / 2.0), kRounding);
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
    return isograsp::pool_of(stable, usual).error->scale;
  };
  for (const auto usual : {ErrorScale::linear, ErrorScale::logarithmic}) {
    EXPECT_EQ(scale(growing, usual), ErrorScale::logarithmic);
    EXPECT_EQ(scale(constant, usual), ErrorScale::linear);
    EXPECT_EQ(scale(alike(10, 10.0, 1.0), usual), usual) << "alike people do not tell";
  }
  growing[3].days[0].trials = {0.0};
  EXPECT_EQ(scale(growing, ErrorScale::logarithmic), ErrorScale::linear) << "no logarithm of zero";
}

TEST(Pool, WithoutAnyVariationKnowsNoError) {
  const auto pool = pool_of(alike(12, 5.0, 0.0));
  EXPECT_EQ(pool.people, 12);
  EXPECT_FALSE(pool.error.has_value());
}

TEST(Pool, TheDegreesOfFreedomAreThoseOfAPersonOutsideThePool) {
  // v = (31 / 50000) / (7 / 300)^2 - 1, df = 2 / (v + (v + 2 (1 + v)) / n)
  const double v = 31.0 / 50000.0 / (7.0 / 300.0 * 7.0 / 300.0) - 1.0;
  for (const int n : {10, 25, 400})
    EXPECT_NEAR(pool_of(alike(n, 10.0, 1.0)).error->df, 2.0 / (v + (2.0 + 3.0 * v) / n), 1e-9);
  EXPECT_LT(pool_of(alike(4000, 10.0, 1.0)).error->df, 2.0 / v);
}

TEST(Mdc95, IsTheFormula) {
  MeasurementError error{ErrorScale::linear, 3.0, 4.0, 10.0, 2.0};
  // 2 sqrt(9 (1/2 + 1/1) + 16 (1/4 + 1/2))
  EXPECT_NEAR(mdc95(error, {2, 4.0}, {1, 2.0}), 2.0 * std::sqrt(13.5 + 12.0), kRounding);
  const auto pool = pool_of(alike(10, -10.0, 1.0));
  EXPECT_NEAR(pool.error->t975, 2.5332, 5e-5)
      << "t table: 2.571 at 5, 2.447 at 6 degrees of freedom";
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
ChangeJudgement judged(const std::vector<double>& means, Better better = Better::higher,
                       const StablePool& pool = unit_pool()) {
  return judge_change(course(means), pool, better);
}

TEST(Judge, TheBaselineIsTheMeanOfTwoDays) {
  const auto one = judge_change(std::vector{day(0, {9.0, 11.0}), day(4, {12.0}), day(9, {11.5})},
                                unit_pool(), Better::higher);
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
  EXPECT_EQ(judged({10, 10, 8.5}, Better::higher).verdict, Verdict::worsened);
  EXPECT_EQ(judged({10, 10, 8.5}, Better::lower).verdict, Verdict::improved);
  EXPECT_EQ(judged({-3, -3, -1.5}, Better::near_zero).verdict, Verdict::improved);
  EXPECT_EQ(judged({-3, -3, 3.5}, Better::near_zero).verdict, Verdict::within_error);
  EXPECT_EQ(judged({-3, -3, 4.5}, Better::near_zero).verdict, Verdict::worsened);
  EXPECT_EQ(judged({10, 10, 8}, Better::unknown).why, WhyNotJudged::no_direction);
}

TEST(Judge, OnLogarithmsTheErrorIsAShareOfTheBaseline) {
  const auto one = judged({10, 10, 26}, Better::higher, unit_pool(ErrorScale::logarithmic));
  EXPECT_EQ(one.verdict, Verdict::within_error);  // log 2.6 < 1
  EXPECT_NEAR(*one.mdc_up, 10.0 * (std::exp(1.0) - 1.0), 1e-9);
  EXPECT_NEAR(*one.mdc_down, 10.0 * (std::exp(-1.0) - 1.0), 1e-9);
  EXPECT_EQ(judged({10, 10, 28}, Better::higher, unit_pool(ErrorScale::logarithmic)).verdict,
            Verdict::improved);
}

TEST(Judge, OnLogarithmsAValueThatIsNotPositiveIsBelowEveryLimit) {
  const auto log = unit_pool(ErrorScale::logarithmic);
  const auto lost = judged({10, 10, 0}, Better::higher, log);
  EXPECT_EQ(lost.verdict, Verdict::worsened);
  EXPECT_FALSE(lost.confirmed);
  const auto lost_twice = judged({10, 10, 0, 0}, Better::higher, log);
  EXPECT_EQ(lost_twice.verdict, Verdict::worsened);
  EXPECT_TRUE(lost_twice.confirmed);
  EXPECT_TRUE(judged({10, 10, -0.1, 0.5}, Better::higher, log).confirmed);
  EXPECT_EQ(judged({10, 10, -0.5}, Better::lower, log).verdict, Verdict::improved);
  EXPECT_EQ(judged({0, 0, 10}, Better::higher, log).why, WhyNotJudged::not_positive);
  EXPECT_EQ(judged({-1, 0.5, 10}, Better::higher, log).why, WhyNotJudged::not_positive);
}

TEST(Judge, TheBaselineIsTheFirstTwoDaysWithAMean) {
  const AssessmentDay empty{0, {}, false};
  for (const auto& lost : {failed_day(0), empty}) {
    const auto one =
        judge_change(std::vector{lost, day(1, {10.0}), lost, day(3, {12.0}), day(4, {11.5})},
                     unit_pool(), Better::higher);
    EXPECT_EQ(one.baseline, 11.0);
    EXPECT_EQ(one.verdict, Verdict::within_error);
    EXPECT_EQ(
        judge_change(std::vector{lost, day(1, {10.0}), day(2, {10.0})}, unit_pool(), Better::higher)
            .why,
        WhyNotJudged::nothing_after);
  }
  const auto twice = judge_change(
      std::vector{failed_day(0), day(1, {10}), day(2, {10}), day(3, {12}), day(4, {12})},
      unit_pool(), Better::higher);
  EXPECT_TRUE(twice.confirmed);
  const auto once =
      judge_change(std::vector{day(0, {10}), failed_day(1), day(2, {12}), day(3, {14})},
                   unit_pool(), Better::higher);
  EXPECT_FALSE(once.confirmed) << "the day before belongs to the baseline";
}

TEST(Judge, SaysWhyItCannot) {
  EXPECT_EQ(judged({10}).why, WhyNotJudged::baseline_too_short);
  EXPECT_EQ(judged({10, 10}).why, WhyNotJudged::nothing_after);
  EXPECT_EQ(judged({10, 10, 20}, Better::higher, {9, 9, {}}).why, WhyNotJudged::too_few_people);
  EXPECT_EQ(judged({10, 10, 20}, Better::higher, {10, 10, {}}).why, WhyNotJudged::no_variation);
  const auto judge = [](std::vector<AssessmentDay> days) {
    return judge_change(days, unit_pool(), Better::higher);
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
    return *judge_change(days, pool, Better::higher).mdc_up;
  };
  const double single = mdc({day(0, {1}), day(1, {1}), day(2, {1})});
  const double twice = mdc({day(0, {1, 1}), day(1, {1, 1}), day(2, {1, 1})});
  const double uneven = mdc({day(0, {1}), day(1, {1, 1, 1}), day(2, {1, 1})});
  EXPECT_NEAR(single, std::sqrt(1.5), kRounding);
  EXPECT_NEAR(twice, std::sqrt(0.75), kRounding);
  EXPECT_NEAR(uneven, std::sqrt((1.0 + 1.0 / 3.0) / 4.0 + 0.5), kRounding);
}

}  // namespace
}  // namespace isograsp
