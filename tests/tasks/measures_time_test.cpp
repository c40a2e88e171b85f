// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures_time.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp {
namespace {

using test::sampled;
using test::times;

/// Sum of two sines that repeat only after 50 s: one clear correlation peak.
double wander(double s) {
  return std::sin(1.3 * s) + 0.6 * std::sin(2.9 * s + 1.0);
}

Computed lag_of_delay(double delay_s, double rate_Hz) {
  const auto t = times(static_cast<std::size_t>(30.0 * rate_Hz), rate_Hz);
  return lag({1.0 / rate_Hz, sampled(t, wander)},
             {1.0 / rate_Hz, sampled(t, [&](double s) { return wander(s - delay_s); })});
}

TEST(MeasuresTime, LagOfAPureDelayIsTheDelayInBothDirectionsAndAtAnyRate) {
  constexpr double kParabola_s = 2e-4;  // a parabola is not quite the top of the correlation
  for (const double delay_s : {0.05, 0.15, 0.253, -0.2, 0.0, 1.2})
    for (const double rate_Hz : {100.0, 500.0}) {
      const Computed found = lag_of_delay(delay_s, rate_Hz);
      ASSERT_TRUE(found.value) << found.reason;
      EXPECT_NEAR(*found.value, delay_s, kParabola_s) << rate_Hz;
    }
}

TEST(MeasuresTime, LagIsFoundOnARampWithKneesWhereSumsOverAShrinkingOverlapFindZero) {
  const auto t = times(2000);
  const auto ramp = [](double s) { return std::clamp(s - 5.0, 0.0, 10.0); };
  const Computed found =
      lag({0.01, sampled(t, ramp)}, {0.01, sampled(t, [&](double s) { return ramp(s - 0.25); })});
  constexpr double kOneSample_s = 0.01;
  ASSERT_TRUE(found.value) << found.reason;
  EXPECT_NEAR(*found.value, 0.25, kOneSample_s);
}

TEST(MeasuresTime, LagHasNoValueWithoutVariationCorrelationOrPeak) {
  const auto t = times(1000);
  const UniformSamples flat{0.01, std::vector<double>(1000, 0.1)};
  const UniformSamples moving{0.01, sampled(t, wander)};
  EXPECT_FALSE(lag(moving, flat).value);
  EXPECT_FALSE(lag(flat, moving).value);
  UniformSamples noise{0.01, {}};
  std::uint64_t state = 1;
  for (int k = 0; k < 1000; ++k) {
    state = (1103515245u * state + 12345u) % (1u << 31);
    noise.values.push_back(static_cast<double>(state));
  }
  EXPECT_FALSE(lag(moving, noise).value);
  const UniformSamples late{0.01, sampled(times(1000), [](double s) { return wander(s - 1.9); })};
  EXPECT_FALSE(lag(moving, late).value) << "the peak lies beyond the search range";
}

TEST(MeasuresTime, GainIsTheRatioOfAmplitudesWhateverTheLagAndOffset) {
  constexpr double kRounding = 1e-12;
  const double omega = 2.0 * std::numbers::pi * 0.2;
  for (const double rate_Hz : {100.0, 500.0}) {
    const auto t = times(static_cast<std::size_t>(17.3 * rate_Hz), rate_Hz);
    const auto target = sampled(t, [&](double s) { return 20.0 - 10.0 * std::cos(omega * s); });
    const auto actual =
        sampled(t, [&](double s) { return 18.0 - 8.343 * std::cos(omega * (s - 0.2)); });
    EXPECT_NEAR(gain(t, target, actual, 0.2).value.value(), 0.8343, kRounding);
  }
  const auto t = times(400);
  EXPECT_FALSE(gain(t, t, t, 0.2).value) << "less than one cycle";
}

TEST(MeasuresTime, StepResponsesMatchTheIndependentOracle) {
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
    EXPECT_NEAR(response.t10_s.value(), fields[1], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.t63_s.value(), fields[2], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.t90_s.value(), fields[3], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.rise10_90_s.value(), fields[4], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.overshoot, fields[5], kOracleTolerance) << c.name;
    EXPECT_NEAR(response.settle2pct_s.value(), fields[8], kOracleTolerance) << c.name;
  }
}

TEST(MeasuresTime, AStepInEitherDirectionAndSizeHasTheSameResponse) {
  const auto t = times(500);
  const auto up = sampled(t, [](double s) { return 1.0 - std::exp(-s / 0.2); });
  auto down = up;
  for (double& value : down) value *= -3.0;
  const StepResponse a = step_response(t, up, 1.0);
  const StepResponse b = step_response(t, down, -3.0);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(a.rise10_90_s.value(), b.rise10_90_s.value(), kRounding);
  EXPECT_EQ(a.settle2pct_s, b.settle2pct_s);
  constexpr double kLinearCrossing_s = 1e-3;  // straight lines through a curve sampled at 100 Hz
  EXPECT_NEAR(a.rise10_90_s.value(), 0.4394, kLinearCrossing_s);
}

TEST(MeasuresTime, ALevelThatIsNeverReachedHasNoTime) {
  const StepResponse response = step_response(times(3), std::vector<double>{0.0, 0.3, 0.5}, 1.0);
  EXPECT_TRUE(response.t10_s);
  EXPECT_FALSE(response.t63_s);
  EXPECT_FALSE(response.rise10_90_s);
  EXPECT_FALSE(response.settle2pct_s);
}

}  // namespace
}  // namespace isograsp
