// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/sine.hpp"

#include <array>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::sine_test {
namespace {

using test::sampled;
using test::times;

TEST(Sine, GainIsTheRatioOfAmplitudesWhateverTheLagAndOffset) {
  constexpr double kRounding = 1e-12;
  const double omega = 2.0 * std::numbers::pi * 0.2;
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto t = times(static_cast<std::size_t>(17.3 * rate_Hz), rate_Hz);
    const auto target = sampled(t, [&](double s) { return 20.0 - 10.0 * std::cos(omega * s); });
    const auto actual =
        sampled(t, [&](double s) { return 18.0 - 8.343 * std::cos(omega * (s - 0.2)); });
    EXPECT_WITHIN(gain(t, target, actual, 0.2).value.value(), 0.8343, kRounding);
  }
  const auto t = times(400);
  EXPECT_FALSE(gain(t, t, t, 0.2).value) << "less than one cycle";
}

constexpr std::array kFrequencies_Hz{0.1, 0.17, 0.29, 0.43};

double multisine(double s) {
  double sum = 12.0;
  for (std::size_t i = 0; i < kFrequencies_Hz.size(); ++i)
    sum += (1.0 + static_cast<double>(i)) *
           std::sin(2.0 * std::numbers::pi * kFrequencies_Hz[i] * s + static_cast<double>(i));
  return sum;
}

TEST(Sines, EachSineIsFoundExactlyThoughNoneHasWholeCyclesAtAnyRate) {
  constexpr double kRounding = 1e-11;
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto t = times(static_cast<std::size_t>(23.4 * rate_Hz), rate_Hz, 3.0);
    const SinesFit fit = fit_sines(t, sampled(t, multisine), kFrequencies_Hz);
    ASSERT_EQ(fit.sines.size(), kFrequencies_Hz.size()) << english(fit.reason);
    EXPECT_WITHIN(fit.offset, 12.0, kRounding);
    for (std::size_t i = 0; i < fit.sines.size(); ++i) {
      EXPECT_WITHIN(fit.sines[i].amplitude, 1.0 + static_cast<double>(i), kRounding);
      EXPECT_WITHIN(fit.sines[i].phase_rad, static_cast<double>(i), kRounding);
    }
  }
}

TEST(Sines, AtIrregularTimesTheFitIsTheSame) {
  auto t = times(2400);
  for (std::size_t k = 0; k < t.size(); ++k)
    t[k] += 0.004 * std::sin(1.7 * static_cast<double>(k * k % 1000));
  const SinesFit fit = fit_sines(t, sampled(t, multisine), kFrequencies_Hz);
  constexpr double kRounding = 1e-11;
  ASSERT_EQ(fit.sines.size(), kFrequencies_Hz.size()) << english(fit.reason);
  EXPECT_WITHIN(fit.sines[2].amplitude, 3.0, kRounding);
  EXPECT_WITHIN(fit.sines[2].phase_rad, 2.0, kRounding);
}

TEST(Sines, OneSineIsTheSingleFit) {
  const auto t = times(1730);
  const auto x = sampled(t, [](double s) { return std::sqrt(1.0 + s) + 0.3 * std::cos(1.2 * s); });
  const auto single = fit_sine(t, x, 0.2);
  const SinesFit joint = fit_sines(t, x, std::array{0.2});
  ASSERT_TRUE(single);
  ASSERT_EQ(joint.sines.size(), 1u);
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(joint.offset, single->offset, kRounding);
  EXPECT_WITHIN(joint.sines[0].amplitude, single->amplitude, kRounding);
  EXPECT_WITHIN(joint.sines[0].phase_rad, single->phase_rad, kRounding);
}

TEST(Sines, ADelayIsTheSameLagAtEveryFrequencyAndAnyOriginOfTime) {
  constexpr double kRounding = 1e-10;
  for (const double origin_s : {0.0, 100.0})
    for (const double delay_s : {0.3, -0.2}) {
      const auto t = times(3000, 100.0, origin_s);
      const auto actual = sampled(t, [&](double s) { return 0.8 * multisine(s - delay_s); });
      for (const SineAnswer& answer :
           test::every(sine_answers(t, sampled(t, multisine), actual, kFrequencies_Hz))) {
        EXPECT_WITHIN(answer.gain.value.value(), 0.8, kRounding);
        EXPECT_WITHIN(answer.lag_s.value.value(), delay_s, kRounding);
        EXPECT_WITHIN(answer.phase_rad.value.value(),
                      -2.0 * std::numbers::pi * answer.frequency_Hz * delay_s, kRounding);
      }
    }
}

TEST(Sines, ALagIsKnownUpToWholeCycles) {
  const auto t = times(3000);
  const auto sine = [](double s) { return std::sin(2.0 * std::numbers::pi * 0.5 * s); };
  const auto late = sampled(t, [&](double s) { return sine(s - 1.7); });  // a cycle is 2 s
  EXPECT_WITHIN(sine_answers(t, sampled(t, sine), late, std::array{0.5})[0].lag_s.value.value(),
                -0.3, 1e-10);
}

TEST(Sines, FrequenciesNeedAWholeCycleOfTheirDifference) {
  const auto x = [](const std::vector<double>& t) { return sampled(t, multisine); };
  const auto long_enough = times(1429);  // 1 / 0.07 Hz = 14.29 s
  EXPECT_TRUE(fit_sines(long_enough, x(long_enough), kFrequencies_Hz).reason.empty());
  const auto too_short = times(1428);
  EXPECT_FALSE(fit_sines(too_short, x(too_short), kFrequencies_Hz).reason.empty());
  EXPECT_FALSE(fit_sines(long_enough, x(long_enough), std::array{0.2, 0.2}).reason.empty());
  for (const SineAnswer& answer :
       test::every(sine_answers(too_short, x(too_short), x(too_short), kFrequencies_Hz))) {
    EXPECT_FALSE(answer.gain.value);
    EXPECT_FALSE(answer.lag_s.reason.empty());
  }
}

TEST(Sines, WhatTheTargetDoesNotAskHasNoGainAndWhatIsNotAnsweredNoPhase) {
  const auto t = times(3000);
  const auto target =
      sampled(t, [](double s) { return std::sin(2.0 * std::numbers::pi * 0.2 * s); });
  const auto answers = sine_answers(t, target, target, std::array{0.2, 0.3});
  EXPECT_WITHIN(answers[0].gain.value.value(), 1.0, 1e-12);
  EXPECT_FALSE(answers[1].gain.value);
  const std::vector<double> still(3000, 0.0);
  const auto unanswered = sine_answers(t, target, still, std::array{0.2});
  EXPECT_EQ(unanswered[0].gain.value, 0.0);
  EXPECT_FALSE(unanswered[0].lag_s.value);
}

}  // namespace
}  // namespace isograsp::tasks::sine_test
