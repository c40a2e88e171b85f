// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/delay.hpp"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::delay_test {
namespace {

using test::sampled;
using test::times;

/// Sum of two sines that repeat only after 50 s: one clear correlation peak.
double wander(double s) {
  return std::sin(1.3 * s) + 0.6 * std::sin(2.9 * s + 1.0);
}

statistics::Computed lag_of_delay(double delay_s, double rate_Hz) {
  const auto t = times(static_cast<std::size_t>(30.0 * rate_Hz), rate_Hz);
  return lag({1.0 / rate_Hz, sampled(t, wander)},
             {1.0 / rate_Hz, sampled(t, [&](double s) { return wander(s - delay_s); })});
}

TEST(Delay, LagOfAPureDelayIsTheDelayInBothDirectionsAndAtAnyRate) {
  constexpr double kParabola_s = 2e-4;  // a parabola is not quite the top of the correlation
  for (const double delay_s : {0.05, 0.15, 0.253, -0.2, 0.0, 1.2})
    for (const double rate_Hz : {100.0, 500.0}) {
      const statistics::Computed found = lag_of_delay(delay_s, rate_Hz);
      ASSERT_TRUE(found.value) << english(found.reason);
      EXPECT_WITHIN(*found.value, delay_s, kParabola_s) << rate_Hz;
    }
}

TEST(Delay, LagIsFoundOnARampWithKneesWhereSumsOverAShrinkingOverlapFindZero) {
  const auto t = times(2000);
  const auto ramp = [](double s) { return std::clamp(s - 5.0, 0.0, 10.0); };
  const statistics::Computed found =
      lag({0.01, sampled(t, ramp)}, {0.01, sampled(t, [&](double s) { return ramp(s - 0.25); })});
  constexpr double kOneSample_s = 0.01;
  ASSERT_TRUE(found.value) << english(found.reason);
  EXPECT_WITHIN(*found.value, 0.25, kOneSample_s);
}

/// The definition word by word: every shift, every overlap, two passes.
std::optional<double> lag_by_definition(const statistics::UniformSamples& target,
                                        const statistics::UniformSamples& actual) {
  const auto n = static_cast<int>(target.values.size());
  const int most = static_cast<int>(std::lround(1.5 / target.step_s));
  const auto r = [&](int shift) {
    const int first = std::max(0, -shift);
    const int last = std::min(n, n - shift);
    if (last - first < 3) return -2.0;  // no correlation
    const auto x = [&](int k) { return target.values[static_cast<std::size_t>(k)]; };
    const auto y = [&](int k) { return actual.values[static_cast<std::size_t>(k + shift)]; };
    double x_mean = 0.0, y_mean = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
    for (int k = first; k < last; ++k) {
      x_mean += x(k) / (last - first);
      y_mean += y(k) / (last - first);
    }
    for (int k = first; k < last; ++k) {
      xx += (x(k) - x_mean) * (x(k) - x_mean);
      yy += (y(k) - y_mean) * (y(k) - y_mean);
      xy += (x(k) - x_mean) * (y(k) - y_mean);
    }
    return xy / std::sqrt(xx * yy);
  };
  int peak = -most;
  for (int shift = -most; shift <= most; ++shift)
    if (r(shift) > r(peak)) peak = shift;
  if (r(peak) < 0.35 || std::abs(peak) == most) return std::nullopt;
  const double before = r(peak - 1), here = r(peak), after = r(peak + 1);
  if (before < -1.5 || after < -1.5) return std::nullopt;
  return (peak + 0.5 * (before - after) / (before - 2.0 * here + after)) * target.step_s;
}

TEST(Delay, LagIsThatOfTheDefinitionOnNoisyShortAndLopsidedRecords) {
  Random random(7);
  constexpr double kIdentical_s = 1e-9;
  for (const std::size_t count : {350u, 1000u, 2048u})
    for (const double noise : {0.0, 0.05, 0.5, 3.0})
      for (const double offset : {0.0, 1e4})
        for (const double delay_s : {0.237, -0.4}) {
          const auto t = times(count);
          statistics::UniformSamples target{0.01, sampled(t, wander)};
          statistics::UniformSamples actual{0.01, {}};
          for (const double s : t)
            actual.values.push_back(offset + 3.0 * wander(s - delay_s) + noise * random.gaussian());
          // Rest for the first half: many overlaps hold hardly any of the change.
          if (noise == 0.05)
            std::fill_n(target.values.begin(), count / 2, target.values[count / 2]);
          const statistics::Computed found = lag(target, actual);
          const auto expected = lag_by_definition(target, actual);
          ASSERT_EQ(found.value.has_value(), expected.has_value()) << english(found.reason);
          if (expected) {
            EXPECT_WITHIN(*found.value, *expected, kIdentical_s);
          }
        }
}

/// Two samples always correlate wholly: such overlaps must hide no peak.
TEST(Delay, LagIsThatOfTheDefinitionOnRecordsShorterThanTheShifts) {
  Random random(3);
  int with_value = 0;
  for (const std::size_t count : {5u, 6u, 7u, 8u, 12u, 20u, 60u, 140u, 152u, 153u, 160u})
    for (int repetition = 0; repetition < 20; ++repetition) {
      statistics::UniformSamples target{0.01, sampled(times(count), wander)};
      statistics::UniformSamples actual = target;
      for (double& value : actual.values) value += 0.1 * random.gaussian();
      const statistics::Computed found = lag(target, actual);
      const auto expected = lag_by_definition(target, actual);
      ASSERT_EQ(found.value.has_value(), expected.has_value())
          << english(found.reason) << " " << count;
      if (!expected) continue;
      ++with_value;
      constexpr double kIdentical_s = 1e-9;
      EXPECT_WITHIN(*found.value, *expected, kIdentical_s) << count;
    }
  EXPECT_GT(with_value, 50);
}

TEST(Delay, AStepAtTheVeryEndIsFoundThoughMostOverlapsAreConstant) {
  statistics::UniformSamples target{0.01, std::vector<double>(1000, 2.0)};
  statistics::UniformSamples actual = target;
  for (std::size_t k = 990; k < 1000; ++k) target.values[k] = 3.0;
  for (std::size_t k = 994; k < 1000; ++k) actual.values[k] = 3.0;
  const statistics::Computed found = lag(target, actual);
  ASSERT_TRUE(found.value) << english(found.reason);
  EXPECT_WITHIN(*found.value, 0.04, 0.005);
}

TEST(Delay, LagHasNoValueWithoutVariationCorrelationOrPeak) {
  const auto t = times(1000);
  const statistics::UniformSamples flat{0.01, std::vector<double>(1000, 0.1)};
  const statistics::UniformSamples moving{0.01, sampled(t, wander)};
  EXPECT_FALSE(lag(moving, flat).value);
  EXPECT_FALSE(lag(flat, moving).value);
  statistics::UniformSamples noise{0.01, {}};
  std::uint64_t state = 1;
  for (int k = 0; k < 1000; ++k) {
    state = (1103515245u * state + 12345u) % (1u << 31);
    noise.values.push_back(static_cast<double>(state));
  }
  EXPECT_FALSE(lag(moving, noise).value);
  const statistics::UniformSamples late{
      0.01, sampled(times(1000), [](double s) { return wander(s - 1.9); })};
  EXPECT_FALSE(lag(moving, late).value) << "the peak lies beyond the search range";
}

}  // namespace
}  // namespace isograsp::tasks::delay_test
