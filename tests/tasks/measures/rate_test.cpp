// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/rate.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::rate_test {
namespace {

using test::sampled;
using test::times;

constexpr double kForgottenStart = 1e-5;  ///< what the filter still knows of its start

TEST(Rate, OfARampIsItsSlopeAtAnySampleAndRate) {
  for (const double rate_Hz : {100.0, 500.0}) {
    const statistics::UniformSamples ramp{
        1.0 / rate_Hz, sampled(times(500, rate_Hz), [](double s) { return 2.0 - 7.0 * s; })};
    const auto slopes = rate_of_change(ramp);
    ASSERT_TRUE(slopes);
    for (const double slope : test::every(slopes->values))
      EXPECT_WITHIN(slope, -7.0, 7.0 * kForgottenStart);
  }
}

TEST(Rate, OfASineIsThatOfTheFilteredSine) {
  // Gain of the two passes 1 / (1 + (w/wc)^4), of a central difference sin(w dt) / (w dt).
  for (const double rate_Hz : {100.0, 500.0}) {
    const double omega = 2.0 * std::numbers::pi * 2.0;
    const auto t = times(static_cast<std::size_t>(10.0 * rate_Hz), rate_Hz);
    const auto x = sampled(t, [&](double s) { return 4.0 * std::sin(omega * s); });
    const double warped =
        std::tan(omega / rate_Hz / 2.0) / std::tan(std::numbers::pi * 5 / rate_Hz);
    const double expected =
        4.0 * rate_Hz * std::sin(omega / rate_Hz) / (1.0 + std::pow(warped, 4.0));
    constexpr double kSampledTop = 1e-2;  // the steepest point may lie between two samples
    EXPECT_WITHIN(peak_rate(t, x).value.value() / expected, 1.0, kSampledTop);
    EXPECT_WITHIN(peak_relaxation(t, x).value.value() / expected, 1.0, kSampledTop);
  }
}

TEST(Rate, RelaxationIsTheRiseOfTheMirroredForce) {
  const auto t = times(400);
  auto x = sampled(t, [](double s) { return 10.0 / (1.0 + std::exp(-12.0 * (s - 2.0))); });
  const double rise = peak_rate(t, x).value.value();
  EXPECT_GT(rise, 20.0);
  EXPECT_LT(rise, 30.0);  // 10 * 12 / 4, less what the low-pass takes
  for (double& value : x) value = -value;
  EXPECT_DOUBLE_EQ(peak_relaxation(t, x).value.value(), rise);
  const std::vector<double> flat(400, 5.0);
  EXPECT_FALSE(peak_rate(t, flat).value && *peak_rate(t, flat).value > 1e-9);
}

TEST(Rate, EarlyRateIsTheMeanRateOfTheFirst200Milliseconds) {
  for (const double rate_Hz : {100.0, 500.0, 70.0}) {  // at 70 Hz 0.2 s lie between two samples
    const auto t = times(static_cast<std::size_t>(2.0 * rate_Hz), rate_Hz, 3.0);
    const auto x = sampled(t, [](double s) { return 1.0 + 30.0 * std::max(0.0, s - 4.0); });
    const auto start = static_cast<std::size_t>(rate_Hz);
    constexpr double kRounding = 1e-9;
    EXPECT_WITHIN(early_rate(t, x, start).value.value(), 30.0, kRounding) << rate_Hz;
  }
  const auto t = times(100);
  EXPECT_FALSE(early_rate(t, t, 85).value) << "150 ms are left";
  EXPECT_WITHIN(early_rate(t, t, 79).value.value(), 1.0, 1e-9) << "200 ms are left";
}

/// A ramp of `slope` with pauses from 1 to 1.6 s and from 3 to 3.4 s, and a stop of 60 ms at 4 s.
std::vector<double> ramp_with_pauses(const std::vector<double>& t_s, double slope) {
  return sampled(t_s, [&](double s) {
    const double lost = std::clamp(s - 1.0, 0.0, 0.6) + std::clamp(s - 3.0, 0.0, 0.4) +
                        std::clamp(s - 4.0, 0.0, 0.06);
    return slope * (s - lost);
  });
}

TEST(Rate, PausesAreCountedAndMeasuredInAnyUnitAndDirection) {
  constexpr double kSmoothing_s = 0.06;  // 40 % is reached a little inside the rounded corners
  for (const double rate_Hz : {100.0, 500.0})
    for (const double slope : {2.0, 2000.0, -2.0}) {
      const auto t = times(static_cast<std::size_t>(5.0 * rate_Hz), rate_Hz);
      const Pauses found = pauses(t, ramp_with_pauses(t, slope), slope);
      EXPECT_EQ(found.count.value, 2.0);
      EXPECT_WITHIN(found.mean_length_s.value.value(), 0.5, kSmoothing_s);
    }
}

TEST(Rate, ASteadyRampHasNoPausesAndAHalfSpeedOneNeither) {
  const auto t = times(500);
  for (const double slope : {1.0, 0.5}) {
    const auto x = sampled(t, [&](double s) { return slope * s; });
    EXPECT_EQ(pauses(t, x, 1.0).count.value, 0.0);
    EXPECT_EQ(english(pauses(t, x, 1.0).mean_length_s.reason), "no pauses");
  }
}

TEST(Rate, TooFewOrTooSlowSamplesAreAReason) {
  EXPECT_FALSE(peak_rate(times(2), times(2)).value);
  EXPECT_FALSE(peak_rate(times(100, 10.0), times(100, 10.0)).value);
  EXPECT_FALSE(pauses({}, {}, 1.0).count.value);
}

}  // namespace
}  // namespace isograsp::tasks::rate_test
