// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/steadiness.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::steadiness_test {
namespace {

using test::sampled;
using test::times;

/// 10 N mean, falling by 2 N over 10 s, with a 5 Hz ripple of 0.2 N.
std::vector<double> plateau(const std::vector<double>& t_s) {
  return sampled(t_s, [&](double s) {
    const double since_s = s - t_s.front();
    return 11.0 - 0.2 * since_s + 0.2 * std::sin(2.0 * std::numbers::pi * 5.0 * since_s);
  });
}

TEST(Steadiness, IsThatOfTheRippleWhateverTheDriftTheRateAndTheOriginOfTime) {
  constexpr double kRippleInLine = 2e-3;  // the line takes a little of 50 cycles; ends of the grid
  for (const double rate_Hz : {100.0, 500.0})
    for (const double origin_s : {0.0, 777.0}) {
      const auto t = times(static_cast<std::size_t>(10.0 * rate_Hz), rate_Hz, origin_s);
      const Steadiness found = steadiness(t, plateau(t), 0.001);
      EXPECT_WITHIN(found.sd.value.value(), 0.2 / std::numbers::sqrt2, kRippleInLine);
      EXPECT_WITHIN(found.cv_percent.value.value(), 2.0 / std::numbers::sqrt2, 10 * kRippleInLine);
      EXPECT_WITHIN(found.noise_floor_percent.value.value(), 0.01, 1e-4);
      EXPECT_WITHIN(found.fall_percent.value.value(), 20.0, 0.5);
    }
}

TEST(Steadiness, AnotherUnitChangesTheDeviationOnly) {
  const auto t = times(1000);
  auto x = plateau(t);
  const Steadiness newton = steadiness(t, x, 0.01);
  for (double& value : x) value *= 1024.0;  // a power of two: exact
  const Steadiness other = steadiness(t, x, 10.24);
  EXPECT_DOUBLE_EQ(*other.sd.value, 1024.0 * *newton.sd.value);
  EXPECT_DOUBLE_EQ(*other.cv_percent.value, *newton.cv_percent.value);
  EXPECT_DOUBLE_EQ(*other.noise_floor_percent.value, *newton.noise_floor_percent.value);
  EXPECT_DOUBLE_EQ(*other.fall_percent.value, *newton.fall_percent.value);
}

TEST(Steadiness, ACvThatMayBeNoiseIsBelowResolution) {
  const auto t = times(1000);
  const auto x = plateau(t);
  const double cv_percent = steadiness(t, x, 0.0).cv_percent.value.value();
  const double third_N = cv_percent / 300.0 * 10.0;
  EXPECT_TRUE(steadiness(t, x, 0.98 * third_N).cv_percent.value);
  const Steadiness noisy = steadiness(t, x, 1.02 * third_N);
  EXPECT_FALSE(noisy.cv_percent.value);
  EXPECT_EQ(english(noisy.cv_percent.reason).find("below resolution"), 0u);
  EXPECT_TRUE(noisy.noise_floor_percent.value);
  EXPECT_TRUE(noisy.sd.value);
}

TEST(Steadiness, UnknownNoiseIsNoFloorOfZero) {
  const auto t = times(1000);
  const Steadiness found = steadiness(t, plateau(t), std::nullopt);
  EXPECT_FALSE(found.noise_floor_percent.value);
  EXPECT_TRUE(found.cv_percent.value);
}

TEST(Steadiness, WithoutSamplesOrMeanThereIsAReason) {
  const Steadiness none = steadiness({}, {}, 0.1);
  EXPECT_FALSE(none.sd.value);
  EXPECT_FALSE(none.fall_percent.value);
  const Steadiness zero = steadiness(times(4), std::vector<double>{1.0, -1.0, -1.0, 1.0}, 0.1);
  EXPECT_TRUE(zero.sd.value);
  EXPECT_EQ(english(zero.cv_percent.reason), "the mean is zero");
}

}  // namespace
}  // namespace isograsp::tasks::steadiness_test
