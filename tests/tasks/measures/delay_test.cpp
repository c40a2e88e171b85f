// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/delay.hpp"

#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

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

TEST(Delay, LagOfAPureDelayIsTheDelayInBothDirectionsAndAtAnyRate) {
  constexpr double kParabola_s = 2e-4;  // a parabola is not quite the top of the correlation
  for (const double delay_s : {0.05, 0.15, 0.253, -0.2, 0.0, 1.2})
    for (const double rate_Hz : {100.0, 500.0}) {
      const Computed found = lag_of_delay(delay_s, rate_Hz);
      ASSERT_TRUE(found.value) << found.reason;
      EXPECT_NEAR(*found.value, delay_s, kParabola_s) << rate_Hz;
    }
}

TEST(Delay, LagIsFoundOnARampWithKneesWhereSumsOverAShrinkingOverlapFindZero) {
  const auto t = times(2000);
  const auto ramp = [](double s) { return std::clamp(s - 5.0, 0.0, 10.0); };
  const Computed found =
      lag({0.01, sampled(t, ramp)}, {0.01, sampled(t, [&](double s) { return ramp(s - 0.25); })});
  constexpr double kOneSample_s = 0.01;
  ASSERT_TRUE(found.value) << found.reason;
  EXPECT_NEAR(*found.value, 0.25, kOneSample_s);
}

TEST(Delay, LagHasNoValueWithoutVariationCorrelationOrPeak) {
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

}  // namespace
}  // namespace isograsp
