// SPDX-License-Identifier: GPL-3.0-or-later
// Errors against closed forms; the reference values were computed independently.
#include "tasks/measures/error.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::error_test {
namespace {

using test::sampled;
using test::times;

constexpr double kRounding = 1e-12;        ///< some thousand additions of numbers near one
constexpr double kPrintedDigits = 0.5e-4;  ///< reference values are printed with four decimals

struct Sine {
  double gain;
  double lag_s;
  double rmse;
};

TEST(MeasuresError, RmseOfASineWithGainAndLagIsTheClosedForm) {
  const double omega = 2.0 * std::numbers::pi * 0.2;
  const auto t = times(3000);
  const auto target = sampled(t, [&](double s) { return 20.0 + 10.0 * std::sin(omega * s); });
  const auto weight = statistics::hold_lengths(t);
  for (const Sine& c :
       {Sine{1.0, 0.15, 1.3309}, Sine{0.8343, 0.0, 1.1717}, Sine{0.8343, 0.15, 1.6884}}) {
    const auto actual = sampled(
        t, [&](double s) { return 20.0 + c.gain * 10.0 * std::sin(omega * (s - c.lag_s)); });
    const double closed =
        10.0 / std::sqrt(2.0) *
        std::sqrt(1.0 + c.gain * c.gain - 2.0 * c.gain * std::cos(omega * c.lag_s));
    EXPECT_WITHIN(rmse(target, actual, weight).value.value(), closed, kRounding);
    EXPECT_WITHIN(rmse(target, actual, weight).value.value(), c.rmse, kPrintedDigits);
    EXPECT_WITHIN(relative_rmse(target, actual, weight).value.value(), 100.0 * closed / 30.0, 1e-9);
  }
}

TEST(MeasuresError, AConstantOffsetIsFoundByEveryErrorMeasureWithItsSign) {
  const auto t = times(100);
  const auto target = sampled(t, [](double s) { return 5.0 + s; });
  auto actual = target;
  for (double& value : actual) value -= 0.75;
  const auto weight = statistics::hold_lengths(t);
  EXPECT_WITHIN(constant_error(target, actual, weight).value.value(), -0.75, kRounding);
  EXPECT_WITHIN(mae(target, actual, weight).value.value(), 0.75, kRounding);
  EXPECT_WITHIN(rmse(target, actual, weight).value.value(), 0.75, kRounding);
}

TEST(MeasuresError, RowsWeighAsLongAsTheyHold) {
  const std::vector<double> t{0.0, 1.0, 4.0, 5.0};  // holds 1, 3, 1, 1
  const auto weight = statistics::hold_lengths(t);
  const std::vector<double> target{0.0, 0.0, 0.0, 0.0};
  const std::vector<double> actual{1.0, 2.0, 0.0, -1.0};
  EXPECT_DOUBLE_EQ(constant_error(target, actual, weight).value.value(), 6.0 / 6.0);
  EXPECT_DOUBLE_EQ(mae(target, actual, weight).value.value(), 8.0 / 6.0);
  EXPECT_DOUBLE_EQ(rmse(target, actual, weight).value.value(), std::sqrt(14.0 / 6.0));
}

TEST(MeasuresError, TheRangeIsFivePercentOfTheTargetOrThreeNoiseDeviations) {
  const std::vector<double> weight{1.0, 1.0, 1.0, 1.0};
  const std::vector<double> target{10.0, 10.0, -10.0, 0.0};
  const std::vector<double> actual{10.5, 10.6, -9.5, 0.2};
  EXPECT_DOUBLE_EQ(time_in_range(target, actual, weight).value.value(), 50.0);
  EXPECT_DOUBLE_EQ(time_in_range(target, actual, weight, 0.1).value.value(), 75.0);
  EXPECT_DOUBLE_EQ(time_in_range(target, actual, weight, 0.21).value.value(), 100.0);
}

TEST(MeasuresError, ABandOfChoiceIsTheRangeAtFivePercentAndGrowsWithItsShare) {
  const std::vector<double> weight{1.0, 1.0, 1.0, 1.0};
  const std::vector<double> target{10.0, 10.0, -10.0, 0.0};
  const std::vector<double> actual{10.5, 10.6, -9.5, 0.2};
  for (const double noise_sd : {0.0, 0.1})
    EXPECT_EQ(time_in_band(target, actual, weight, 0.05, noise_sd).value,
              time_in_range(target, actual, weight, noise_sd).value);
  EXPECT_DOUBLE_EQ(time_in_band(target, actual, weight, 0.1, 0.0).value.value(), 75.0);
  EXPECT_DOUBLE_EQ(time_in_band(target, actual, weight, 0.01, 0.0).value.value(), 0.0);
}

TEST(MeasuresError, OutsideACorridorTheDistanceToTheNearerBoundCountsAsLongAsItHolds) {
  const std::vector<double> lower(4, 1.0);
  const std::vector<double> upper(4, 3.0);
  const std::vector<double> actual{0.5, 1.0, 3.0, 5.0};  // below, on both bounds, above
  const std::vector<double> weight{4.0, 1.0, 1.0, 2.0};
  const Corridor found = corridor(lower, upper, actual, weight);
  EXPECT_DOUBLE_EQ(found.time_inside_percent.value.value(), 25.0);
  EXPECT_DOUBLE_EQ(found.mean_outside.value.value(), (4.0 * 0.5 + 2.0 * 2.0) / 8.0);
  EXPECT_DOUBLE_EQ(found.rms_outside.value.value(), std::sqrt((4.0 * 0.25 + 2.0 * 4.0) / 8.0));
}

TEST(MeasuresError, ACorridorWithoutWidthHasTheErrorsOfItsTarget) {
  const auto t = times(500);
  const auto target = sampled(t, [](double s) { return std::sin(s); });
  const auto actual = sampled(t, [](double s) { return std::sin(s - 0.2); });
  const auto weight = statistics::hold_lengths(t);
  const Corridor found = corridor(target, target, actual, weight);
  EXPECT_WITHIN(found.mean_outside.value.value(), mae(target, actual, weight).value.value(),
                kRounding);
  EXPECT_WITHIN(found.rms_outside.value.value(), rmse(target, actual, weight).value.value(),
                kRounding);
  EXPECT_FALSE(corridor({}, {}, {}, {}).mean_outside.value);
}

TEST(MeasuresError, CvIsBlindToALineAndKnowsTheSineRoundIt) {
  const auto t = times(1000);
  const auto ramp = sampled(t, [](double s) { return 3.0 + 0.4 * s; });
  EXPECT_WITHIN(cv(t, ramp).value.value(), 0.0, 1e-10);
  // Whole cycles round a constant mean: SD(n - 1) = A sqrt(n / (2 (n - 1))); the line through a
  // sine of 50 cycles takes away less than the tolerance.
  const auto wave =
      sampled(t, [](double s) { return 4.0 + 0.2 * std::sin(2.0 * std::numbers::pi * 5.0 * s); });
  const double closed = 100.0 * 0.2 * std::sqrt(1000.0 / (2.0 * 999.0)) / 4.0;
  constexpr double kLineThroughASine = 1e-3;
  EXPECT_WITHIN(cv(t, wave).value.value(), closed, kLineThroughASine);
}

TEST(MeasuresError, CvWithoutAMeanHasAReasonAndNoValue) {
  const auto t = times(4);
  const statistics::Computed none = cv(t, std::vector<double>{1.0, -1.0, -1.0, 1.0});
  EXPECT_FALSE(none.value);
  EXPECT_EQ(english(none.reason), "the mean is zero");
}

TEST(MeasuresError, TheBestMovingMeanIsTheBestWholeWindow) {
  const std::vector<double> x{1.0, 1.0, 5.0, 7.0, 1.0, 9.0};
  const std::vector<double> weight(6, 0.1);
  std::vector<bool> valid(6, true);
  EXPECT_DOUBLE_EQ(best_moving_mean(x, weight, valid, 0.2).value.value(), 6.0);
  EXPECT_WITHIN(best_moving_mean(x, weight, valid, 0.3).value.value(), 17.0 / 3.0, kRounding);
  valid[3] = false;  // no window may bridge a sample that does not count
  EXPECT_DOUBLE_EQ(best_moving_mean(x, weight, valid, 0.2).value.value(), 5.0);
  EXPECT_FALSE(best_moving_mean(x, weight, valid, 0.4).value);
}

TEST(MeasuresError, AWindowThatEndsWithinARowTakesItsShare) {
  const std::vector<double> x{4.0, 8.0};
  const std::vector<double> weight{0.2, 0.2};
  EXPECT_WITHIN(best_moving_mean(x, weight, {true, true}, 0.3).value.value(),
                (4.0 * 0.2 + 8.0 * 0.1) / 0.3, kRounding);
}

TEST(MeasuresError, HoldLengthsFollowTheRuleOfTheFileFormat) {
  EXPECT_EQ(statistics::hold_lengths(std::vector<double>{0.0, 0.1, 0.2, 0.30000000000000004}),
            std::vector<double>(4, 0.1));
  EXPECT_EQ(statistics::hold_lengths(std::vector<double>{0.0, 1.0, 3.0}),
            (std::vector<double>{1.0, 2.0, 2.0}));
}

TEST(MeasuresError, NoSamplesIsAReasonNotANumber) {
  const std::vector<double> none;
  for (const statistics::Computed& computed : {rmse(none, none, none), mae(none, none, none),
                                               time_in_range(none, none, none), cv(none, none)}) {
    EXPECT_FALSE(computed.value);
    EXPECT_FALSE(computed.reason.empty());
  }
}

}  // namespace
}  // namespace isograsp::tasks::error_test
