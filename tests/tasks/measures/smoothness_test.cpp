// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/smoothness.hpp"

#include <array>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/tasks/samples.hpp"

namespace isograsp {
namespace {

using test::sampled;
using test::times;

constexpr double kPrintedDigits = 0.5e-5;  ///< reference values are printed with five decimals

UniformSamples gaussian_bump() {
  return {0.01, sampled(times(200, 100.0, -1.0), [](double t) { return std::exp(-5.0 * t * t); })};
}
UniformSamples minimum_jerk() {
  return {0.01, sampled(times(101), [](double t) { return 30.0 * t * t * (1.0 - t) * (1.0 - t); })};
}

TEST(MeasuresSmoothness, SparcAndLdljReproduceThePublishedValues) {
  EXPECT_NEAR(sparc(gaussian_bump()).value.value(), -1.41403, kPrintedDigits);
  EXPECT_NEAR(ldlj(gaussian_bump()).value.value(), -5.81636, kPrintedDigits);
  EXPECT_NEAR(-std::exp(-ldlj(gaussian_bump()).value.value()), -335.74684, kPrintedDigits);
  EXPECT_NEAR(sparc(minimum_jerk()).value.value(), -1.40583, kPrintedDigits);
  EXPECT_NEAR(ldlj(minimum_jerk()).value.value(), -5.30163, kPrintedDigits);
}

TEST(MeasuresSmoothness, SizeOfTheMovementDoesNotMatterAndStopsMakeItLessSmooth) {
  UniformSamples larger = minimum_jerk();
  for (double& v : larger.values) v *= 8.0;  // a power of two: exact
  EXPECT_EQ(sparc(larger).value, sparc(minimum_jerk()).value);
  EXPECT_EQ(ldlj(larger).value, ldlj(minimum_jerk()).value);
  UniformSamples twice = minimum_jerk();
  const UniformSamples once = minimum_jerk();
  twice.values.insert(twice.values.end(), once.values.begin(), once.values.end());
  EXPECT_LT(*sparc(twice).value, *sparc(once).value);
  EXPECT_LT(*ldlj(twice).value, *ldlj(once).value);
}

TEST(MeasuresSmoothness, TheTransformIsTheDefinitionAndKeepsEnergy) {
  std::vector<std::complex<double>> x(64);
  for (std::size_t n = 0; n < x.size(); ++n)
    x[n] = {std::sin(0.3 * static_cast<double>(n * n)), std::cos(1.7 * static_cast<double>(n))};
  auto fast = x;
  fourier_transform(fast);
  constexpr double kRounding = 1e-12;
  double energy = 0.0;
  double spectral_energy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    std::complex<double> slow = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n)
      slow += x[n] *
              std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>((k * n) % 64) / 64.0);
    EXPECT_NEAR(std::abs(fast[k] - slow), 0.0, kRounding);
    energy += std::norm(x[k]);
    spectral_energy += std::norm(fast[k]) / 64.0;
  }
  EXPECT_NEAR(energy, spectral_energy, kRounding);
}

TEST(MeasuresSmoothness, SpeedOfASteadyDiagonalIsExactEverywhere) {
  const UniformSamples x{0.5, {0.0, 1.5, 3.0, 4.5}};
  const UniformSamples y{0.5, {0.0, 2.0, 4.0, 6.0}};
  const std::array axes{x, y};
  for (const double v : speed_of(axes).values) EXPECT_DOUBLE_EQ(v, 5.0);
}

TEST(MeasuresSmoothness, WithoutMovementThereIsAReasonAndNoValue) {
  const UniformSamples still{0.01, std::vector<double>(50, 0.0)};
  EXPECT_EQ(sparc(still).reason, "nothing moved");
  EXPECT_EQ(ldlj(still).reason, "nothing moved");
}

TEST(MeasuresSmoothness, SampleEntropyReproducesTheReferenceCounts) {
  const auto sine =
      sampled(times(1000), [](double t) { return std::sin(2.0 * std::numbers::pi * 0.2 * t); });
  const TemplateMatches of_sine = template_matches(sine);
  EXPECT_EQ(of_sine.longer, 67675);
  EXPECT_EQ(of_sine.shorter, 69575);
  EXPECT_NEAR(sample_entropy(sine).value.value(), 0.02769, kPrintedDigits);

  std::vector<double> noise;
  std::uint64_t state = 1;
  for (int k = 0; k < 500; ++k) {
    state = (1103515245u * state + 12345u) % (std::uint64_t{1} << 31);
    noise.push_back(static_cast<double>(state) / static_cast<double>(std::uint64_t{1} << 31));
  }
  const TemplateMatches of_noise = template_matches(noise);
  EXPECT_EQ(of_noise.longer, 149);
  EXPECT_EQ(of_noise.shorter, 1476);
  EXPECT_NEAR(sample_entropy(noise).value.value(), 2.29314, kPrintedDigits);
}

TEST(MeasuresSmoothness, SampleEntropyIgnoresScaleAndRefusesWhatItCannotCount) {
  std::vector<double> x;
  for (int k = 0; k < 300; ++k) x.push_back(std::sin(0.1 * k) + std::sin(0.37 * k));
  auto scaled = x;
  for (double& value : scaled) value *= 4.0;  // a power of two: exact
  EXPECT_EQ(sample_entropy(x).value, sample_entropy(scaled).value);
  EXPECT_FALSE(sample_entropy(std::vector<double>(100, 2.5)).value);
  EXPECT_FALSE(sample_entropy(std::vector<double>{0.0, 1.0, 10.0, 100.0, 1000.0}).value);
}

TEST(MeasuresSmoothness, IrregularTimesAreResampledAtTheMedianStepAndALineStaysALine) {
  const std::vector<double> t{0.0, 0.1, 0.2, 0.3, 0.55, 0.65, 0.75};
  const auto x = sampled(t, [](double s) { return 2.0 + 3.0 * s; });
  const UniformSamples even = on_uniform_grid(t, x);
  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(even.step_s, 0.1, kRounding);
  ASSERT_EQ(even.values.size(), 8u);
  for (std::size_t i = 0; i < even.values.size(); ++i)
    EXPECT_NEAR(even.values[i], 2.0 + 3.0 * 0.1 * static_cast<double>(i), kRounding);
}

}  // namespace
}  // namespace isograsp
