// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/step.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::step_test {
namespace {

using test::sampled;
using test::times;

TEST(StepResponse, StepResponsesMatchTheIndependentOracle) {
  constexpr double kOracleTolerance = 1e-13;  // what a correct double program reaches
  struct Case {
    const char* name;
    double (*y)(double);
  };
  const Case cases[] = {
      {"first_order_tau0.3_n401", [](double t) { return 1.0 - std::exp(-t / 0.3); }},
      {"second_order_wn6_z0.4_n601",
       [](double t) {
         const double wd = 6.0 * std::sqrt(1.0 - 0.16);
         return 1.0 - std::exp(-2.4 * t) * (std::cos(wd * t) + 2.4 / wd * std::sin(wd * t));
       }},
      {"min_jerk_T1.2_n201",
       [](double t) {
         const double s = std::min(t / 1.2, 1.0);
         return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
       }},
      {"ramp_2s_n301", [](double t) { return std::min(t / 2.0, 1.0); }}};
  const auto text = read_text(ISOGRASP_SOURCE_DIR "/tests/data/golden/metrics_step.csv");
  ASSERT_TRUE(text) << text.error().message();
  for (const Case& c : cases) {
    const auto at = text->find(c.name);
    ASSERT_NE(at, std::string::npos);
    std::string_view line(*text);
    line = line.substr(at, line.find('\n', at) - at);
    std::vector<double> fields;
    for (auto comma = line.find(','); comma != std::string_view::npos;) {
      line.remove_prefix(comma + 1);
      comma = line.find(',');
      double value = 0.0;
      ASSERT_TRUE(parse_number(line.substr(0, comma), value)) << line;
      fields.push_back(value);
    }
    ASSERT_EQ(fields.size(), 9u);
    const auto t = times(static_cast<std::size_t>(fields[0]));
    const auto y = sampled(t, c.y);
    const StepResponse response = step_response(t, y, 1.0);
    EXPECT_WITHIN(response.t10_s.value(), fields[1], kOracleTolerance) << c.name;
    EXPECT_WITHIN(response.t63_s.value(), fields[2], kOracleTolerance) << c.name;
    EXPECT_WITHIN(response.t90_s.value(), fields[3], kOracleTolerance) << c.name;
    EXPECT_WITHIN(response.rise10_90_s.value(), fields[4], kOracleTolerance) << c.name;
    EXPECT_WITHIN(response.overshoot, fields[5], kOracleTolerance) << c.name;
    EXPECT_WITHIN(response.settle2pct_s.value(), fields[8], kOracleTolerance) << c.name;
  }
}

TEST(StepResponse, AStepInEitherDirectionAndSizeHasTheSameResponse) {
  const auto t = times(500);
  const auto up = sampled(t, [](double s) { return 1.0 - std::exp(-s / 0.2); });
  auto down = up;
  for (double& value : down) value *= -3.0;
  const StepResponse a = step_response(t, up, 1.0);
  const StepResponse b = step_response(t, down, -3.0);
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(a.rise10_90_s.value(), b.rise10_90_s.value(), kRounding);
  EXPECT_EQ(a.settle2pct_s, b.settle2pct_s);
  constexpr double kLinearCrossing_s = 1e-3;  // straight lines through a curve sampled at 100 Hz
  EXPECT_WITHIN(a.rise10_90_s.value(), 0.4394, kLinearCrossing_s);
}

TEST(StepResponse, ALevelThatIsNeverReachedHasNoTime) {
  const StepResponse response = step_response(times(3), std::vector<double>{0.0, 0.3, 0.5}, 1.0);
  EXPECT_TRUE(response.t10_s);
  EXPECT_FALSE(response.t63_s);
  EXPECT_FALSE(response.rise10_90_s);
  EXPECT_FALSE(response.settle2pct_s);
}

constexpr double kLsb_N = 0.04;

/// First order, tau = 0.2 s: 1 - exp(-s / tau), none before 0.
double first_order(double s) {
  return s < 0.0 ? 0.0 : 1.0 - std::exp(-s / 0.2);
}
/// m = 0.5 kg, c = 2 N s/m, k = 50 N/m: zeta = 0.2, omega = 10 rad/s.
double second_order(double s) {
  const double damped = 10.0 * std::sqrt(1.0 - 0.04);
  return s < 0.0 ? 0.0
                 : 1.0 - std::exp(-2.0 * s) *
                             (std::cos(damped * s) + 2.0 / damped * std::sin(damped * s));
}

TEST(StepResponse, AFirstOrderAnswerSettlesAtTheReferenceTime) {
  const auto t = times(10000, 5000.0);
  const StepResponse response = step_response(t, sampled(t, first_order), 1.0);
  constexpr double kOneSample_s = 0.0002;
  EXPECT_WITHIN(response.rise10_90_s.value(), 0.4394, 0.5e-4);
  EXPECT_WITHIN(response.settle2pct_s.value(), 0.7824, kOneSample_s);
}

struct Levels {
  double from;
  double to;
};

TEST(CuedStep, AFirstOrderAnswerHasItsClosedFormUpAndDownAtAnyRateLevelAndCue) {
  for (const Levels& level : {Levels{0.0, 1.0}, Levels{5.0, 25.0}, Levels{25.0, 5.0}})
    for (const double rate_Hz : {100.0, 500.0})
      for (const double cue_s : {2.0, 1000.0}) {
        const auto t = times(static_cast<std::size_t>(6.0 * rate_Hz), rate_Hz, cue_s - 2.0);
        const auto x = sampled(t, [&](double s) {
          return level.from + (level.to - level.from) * first_order(s - cue_s);
        });
        const auto found = cued_step_response(t, x, {cue_s, level.from, level.to}, kLsb_N);
        // A straight line through one sample's curve is off by at most dt^2 / (8 tau).
        const double chord_s = 1.0 / (rate_Hz * rate_Hz) / (8.0 * 0.2) + 1e-9;
        EXPECT_WITHIN(found.t10.time_s.value.value(), 0.2 * std::log(1.0 / 0.9), chord_s);
        EXPECT_WITHIN(found.t63.time_s.value.value(), 0.2, chord_s);
        EXPECT_WITHIN(found.rise10_90_s.value.value(), 0.2 * std::log(9.0), chord_s);
        EXPECT_WITHIN(found.settling.time_s.value.value(), 0.2 * std::log(20.0), 1.0 / rate_Hz);
        EXPECT_EQ(found.overshoot_percent.value, 0.0);
        EXPECT_FALSE(found.peak_s.value);
      }
}

TEST(CuedStep, ASecondOrderAnswerHasTheReferenceOvershootAndPeakTime) {
  for (const double size : {1.0, -20.0}) {
    const auto t = times(6000, 1000.0);
    const auto x = sampled(t, [&](double s) { return 30.0 + size * second_order(s - 2.0); });
    const auto found = cued_step_response(t, x, {2.0, 30.0, 30.0 + size}, kLsb_N);
    constexpr double kPrintedPercent = 0.005 + 1e-3;  // and the sampled top
    constexpr double kOneSample_s = 0.001;
    EXPECT_WITHIN(found.overshoot_percent.value.value(), 52.66, kPrintedPercent);
    EXPECT_WITHIN(found.peak_s.value.value(), 0.3206, kOneSample_s);
  }
}

TEST(CuedStep, ReactionIsThatOfThePatientsOwnLevelNotOfTheTarget) {
  const auto t = times(600);
  const auto x = sampled(t, [](double s) { return 11.0 + 10.0 * first_order(s - 2.3); });
  const auto found = cued_step_response(t, x, {2.0, 10.0, 20.0}, kLsb_N);
  constexpr double kOneSample_s = 0.01;
  EXPECT_WITHIN(found.reaction.time.time_s.value.value(), 0.3, kOneSample_s + 0.002);
  EXPECT_EQ(english(found.t10.time_s.reason), "already there at the cue");
  EXPECT_FALSE(found.rise10_90_s.value);
}

TEST(CuedStep, PassingThroughTheBandIsNotSettling) {
  const auto t = times(400);
  const auto x = sampled(t, [](double s) {  // 10 N/s through the target to twice of it and back
    return s < 0.5 ? 0.0 : s < 2.5 ? 10.0 - std::abs(10.0 * (s - 1.5)) : 5.0;
  });
  const auto found = cued_step_response(t, x, {0.5, 0.0, 5.0}, kLsb_N);
  EXPECT_WITHIN(found.settling.time_s.value.value(), 2.0, 1e-9);
  EXPECT_WITHIN(found.overshoot_percent.value.value(), 100.0, 1e-9);
  EXPECT_WITHIN(found.peak_s.value.value(), 1.0, 1e-9);
}

TEST(CuedStep, WhatIsNotReachedIsCensoredAndWhatWasNotAskedIsNot) {
  const auto t = times(501);
  const auto x = sampled(t, [](double s) { return s < 2.0 ? 0.0 : 5.0; });
  const auto found = cued_step_response(t, x, {1.0, 0.0, 10.0}, kLsb_N);
  EXPECT_TRUE(found.t10.time_s.value);
  EXPECT_WITHIN(found.t63.longer_than_s.value(), 4.0, 1e-12);
  EXPECT_WITHIN(found.settling.longer_than_s.value(), 4.0, 1e-12);
  EXPECT_FALSE(found.rise10_90_s.value);
  const auto later = cued_step_response(t, x, {9.0, 0.0, 10.0}, kLsb_N);
  EXPECT_FALSE(later.t10.longer_than_s);
  EXPECT_FALSE(later.overshoot_percent.value);
  const auto at_once = cued_step_response(t, x, {0.0, 0.0, 10.0}, kLsb_N);
  EXPECT_EQ(english(at_once.reaction.time.time_s.reason), "no level before the cue");
}

}  // namespace
}  // namespace isograsp::tasks::step_test
