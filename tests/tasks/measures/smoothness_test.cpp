// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/smoothness.hpp"

#include <array>
#include <bit>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "core/fourier.hpp"
#include "core/random.hpp"
#include "tests/support/every.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::smoothness_test {
namespace {

using test::sampled;
using test::times;

constexpr double kPrintedDigits = 0.5e-5;  ///< reference values are printed with five decimals

statistics::UniformSamples gaussian_bump() {
  return {0.01, sampled(times(200, 100.0, -1.0), [](double t) { return std::exp(-5.0 * t * t); })};
}
statistics::UniformSamples minimum_jerk() {
  return {0.01, sampled(times(101), [](double t) { return 30.0 * t * t * (1.0 - t) * (1.0 - t); })};
}

TEST(MeasuresSmoothness, SparcAndLdljReproduceThePublishedValues) {
  EXPECT_WITHIN(sparc(gaussian_bump()).value.value(), -1.41403, kPrintedDigits);
  EXPECT_WITHIN(ldlj(gaussian_bump()).value.value(), -5.81636, kPrintedDigits);
  EXPECT_WITHIN(-std::exp(-ldlj(gaussian_bump()).value.value()), -335.74684, kPrintedDigits);
  EXPECT_WITHIN(sparc(minimum_jerk()).value.value(), -1.40583, kPrintedDigits);
  EXPECT_WITHIN(ldlj(minimum_jerk()).value.value(), -5.30163, kPrintedDigits);
}

/// By its definition, from all lines of the padded spectrum.
double slow_sparc(const statistics::UniformSamples& speed) {
  std::vector<std::complex<double>> spectrum(std::bit_ceil(speed.values.size()) * 16);
  std::copy(speed.values.begin(), speed.values.end(), spectrum.begin());
  fourier_transform(spectrum);
  const double line_Hz = 1.0 / (speed.step_s * static_cast<double>(spectrum.size()));
  const double top = std::abs(spectrum.front());
  std::size_t first = spectrum.size();
  std::size_t last = 0;
  for (std::size_t k = 0; k <= spectrum.size() / 2; ++k)
    if (static_cast<double>(k) * line_Hz <= 10.0 && std::abs(spectrum[k]) >= 0.05 * top) {
      first = std::min(first, k);
      last = k;
    }
  double arc = 0.0;
  for (std::size_t k = first; k < last; ++k)
    arc += std::hypot(1.0 / static_cast<double>(last - first),
                      (std::abs(spectrum[k + 1]) - std::abs(spectrum[k])) / top);
  return -arc;
}

TEST(MeasuresSmoothness, SparcIsItsDefinitionAtAnyLengthAndRate) {
  constexpr double kRounding = 1e-10;
  Random random(3);
  for (const std::size_t count : {20u, 128u, 500u, 4000u})
    for (const double rate_Hz : {15.0, 40.0, 100.0, 500.0}) {
      statistics::UniformSamples speed{1.0 / rate_Hz, {}};
      double drift = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        drift = 0.97 * drift + random.gaussian();
        speed.values.push_back(std::abs(drift) + 0.3 * random.uniform());
      }
      EXPECT_WITHIN(sparc(speed).value.value(), slow_sparc(speed), kRounding)
          << count << " at " << rate_Hz;
    }
}

TEST(MeasuresSmoothness, SizeOfTheMovementDoesNotMatterAndStopsMakeItLessSmooth) {
  statistics::UniformSamples larger = minimum_jerk();
  for (double& v : larger.values) v *= 8.0;  // a power of two: exact
  EXPECT_EQ(sparc(larger).value, sparc(minimum_jerk()).value);
  EXPECT_EQ(ldlj(larger).value, ldlj(minimum_jerk()).value);
  statistics::UniformSamples twice = minimum_jerk();
  const statistics::UniformSamples once = minimum_jerk();
  twice.values.insert(twice.values.end(), once.values.begin(), once.values.end());
  EXPECT_LT(*sparc(twice).value, *sparc(once).value);
  EXPECT_LT(*ldlj(twice).value, *ldlj(once).value);
}

TEST(MeasuresSmoothness, SpeedOfASteadyDiagonalIsExactEverywhere) {
  const statistics::UniformSamples x{0.5, {0.0, 1.5, 3.0, 4.5}};
  const statistics::UniformSamples y{0.5, {0.0, 2.0, 4.0, 6.0}};
  const std::array axes{x, y};
  for (const double v : test::every(speed_of(axes).values)) EXPECT_DOUBLE_EQ(v, 5.0);
}

TEST(MeasuresSmoothness, AForceHasTheSmoothnessOfAMovementOfItsShapeUpOrDown) {
  // The integral of the minimum-jerk speed: rises by one.
  const auto rise = [](double t) { return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t); };
  const statistics::UniformSamples up{0.01, sampled(times(101), rise)};
  statistics::UniformSamples down = up;
  for (double& value : down.values) value = 1.0 - value;
  constexpr double kDifferences = 1e-2;  // central differences instead of the speed itself
  EXPECT_WITHIN(sparc(rate_of(up)).value.value(), -1.40583, kDifferences);
  constexpr double kRounding = 1e-10;
  EXPECT_WITHIN(sparc(rate_of(up)).value.value(), sparc(rate_of(down)).value.value(), kRounding);
  EXPECT_WITHIN(ldlj(rate_of(up)).value.value(), ldlj(rate_of(down)).value.value(), 1e-6);
}

TEST(MeasuresSmoothness, WithoutMovementThereIsAReasonAndNoValue) {
  const statistics::UniformSamples still{0.01, std::vector<double>(50, 0.0)};
  EXPECT_EQ(english(sparc(still).reason), "nothing moved");
  EXPECT_EQ(english(ldlj(still).reason), "nothing moved");
}

TEST(MeasuresSmoothness, IrregularTimesAreResampledAtTheMedianStepAndALineStaysALine) {
  const std::vector<double> t{0.0, 0.1, 0.2, 0.3, 0.55, 0.65, 0.75};
  const auto x = sampled(t, [](double s) { return 2.0 + 3.0 * s; });
  const statistics::UniformSamples even = statistics::on_uniform_grid(t, x);
  constexpr double kRounding = 1e-12;
  EXPECT_WITHIN(even.step_s, 0.1, kRounding);
  ASSERT_EQ(even.values.size(), 8u);
  for (std::size_t i = 0; i < even.values.size(); ++i)
    EXPECT_WITHIN(even.values[i], 2.0 + 3.0 * 0.1 * static_cast<double>(i), kRounding);
}

}  // namespace
}  // namespace isograsp::tasks::smoothness_test
