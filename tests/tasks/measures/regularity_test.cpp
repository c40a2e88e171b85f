// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/regularity.hpp"

#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::tasks::regularity_test {
namespace {

using test::sampled;
using test::times;

constexpr double kPrintedDigits = 0.5e-5;  ///< reference values are printed with five decimals

/// Every pair of templates compared.
TemplateMatches compared(const std::vector<double>& x) {
  const double n = static_cast<double>(x.size());
  double mean = 0.0;
  for (const double value : x) mean += value;
  mean /= n;
  double squares = 0.0;
  for (const double value : x) squares += (value - mean) * (value - mean);
  const double r = 0.2 * std::sqrt(squares / n);
  TemplateMatches matches;
  for (std::size_t i = 0; i + 2 < x.size(); ++i)
    for (std::size_t j = i + 1; j + 2 < x.size(); ++j) {
      if (std::abs(x[i] - x[j]) > r || std::abs(x[i + 1] - x[j + 1]) > r) continue;
      ++matches.shorter;
      if (std::abs(x[i + 2] - x[j + 2]) <= r) ++matches.longer;
    }
  return matches;
}

TEST(Regularity, CountsAreThoseOfComparingEveryPairWhateverTheSignal) {
  Random random(11);
  using Signal = double (*)(Random&, double before, double t);
  constexpr Signal kSignals[] = {
      [](Random& r, double, double) { return r.gaussian(); },
      [](Random&, double, double t) { return std::sin(1.3 * t); },
      [](Random& r, double before, double) { return before + r.gaussian(); },
      [](Random& r, double, double) { return std::round(3.0 * r.gaussian()); },  // ties
      [](Random& r, double, double t) { return std::round(5.0 * std::sin(t) + r.uniform()); },
      [](Random& r, double, double) { return r.uniform() < 0.01 ? 50.0 : 0.0; },  // outliers
      [](Random&, double, double) { return 2.5; },
      [](Random&, double, double t) { return 10.0 * t; }};
  for (const Signal& signal : kSignals)
    for (const std::size_t count : {3u, 4u, 63u, 64u, 65u, 66u, 127u, 128u, 700u, 2000u}) {
      std::vector<double> x{0.0};
      while (x.size() < count)
        x.push_back(signal(random, x.back(), 0.01 * static_cast<double>(x.size())));
      const TemplateMatches fast = template_matches(x);
      const TemplateMatches slow = compared(x);
      EXPECT_EQ(fast.longer, slow.longer) << "signal " << &signal - kSignals << ", " << count;
      EXPECT_EQ(fast.shorter, slow.shorter) << "signal " << &signal - kSignals << ", " << count;
    }
}

TEST(Regularity, ManySamplesShareFewStoredSetsAndAreStillCountedExactly) {
  constexpr std::size_t kCount = 34000;  // more than 512 sets of 64 ranks
  std::vector<double> x;
  for (std::size_t k = 0; k < kCount; ++k) x.push_back(static_cast<double>(k % 1000));
  // r = 0.2 sqrt((1000^2 - 1) / 12) = 57.7: values up to 57 apart match; a template that runs over
  // the end of a ramp matches others there only.
  const TemplateMatches matches = template_matches(x);
  // 33 whole ramps of 998 rising templates, the last ramp of 998 as well: 34 of each value.
  const std::int64_t ramps = 34;
  const auto pairs_of = [&](std::int64_t values) {
    std::int64_t ordered = 0;
    for (std::int64_t a = 0; a < values; ++a)
      for (std::int64_t b = 0; b < values; ++b) ordered += std::abs(a - b) <= 57;
    return (ordered * ramps * ramps - values * ramps) / 2;
  };
  const std::int64_t over_the_end = 33 * 32 / 2;  // templates (998, 999, 0) and (999, 0, 1)
  EXPECT_EQ(matches.longer, pairs_of(998) + 2 * over_the_end);
  // Of two samples, (998, 999) still rises, and meets the rising ones at most 57 below it.
  EXPECT_EQ(matches.shorter, pairs_of(998) + 2 * over_the_end + 57 * 34 * 33);
}

TEST(Regularity, SampleEntropyReproducesTheReferenceCounts) {
  const auto sine =
      sampled(times(1000), [](double t) { return std::sin(2.0 * std::numbers::pi * 0.2 * t); });
  const TemplateMatches of_sine = template_matches(sine);
  EXPECT_EQ(of_sine.longer, 67675);
  EXPECT_EQ(of_sine.shorter, 69575);
  EXPECT_WITHIN(sample_entropy(sine).value.value(), 0.02769, kPrintedDigits);

  std::vector<double> noise;
  std::uint64_t state = 1;
  for (int k = 0; k < 500; ++k) {
    state = (1103515245u * state + 12345u) % (std::uint64_t{1} << 31);
    noise.push_back(static_cast<double>(state) / static_cast<double>(std::uint64_t{1} << 31));
  }
  const TemplateMatches of_noise = template_matches(noise);
  EXPECT_EQ(of_noise.longer, 149);
  EXPECT_EQ(of_noise.shorter, 1476);
  EXPECT_WITHIN(sample_entropy(noise).value.value(), 2.29314, kPrintedDigits);
}

TEST(Regularity, SampleEntropyIgnoresScaleAndRefusesWhatItCannotCount) {
  std::vector<double> x;
  for (int k = 0; k < 300; ++k) x.push_back(std::sin(0.1 * k) + std::sin(0.37 * k));
  auto scaled = x;
  for (double& value : scaled) value *= 4.0;  // a power of two: exact
  EXPECT_EQ(sample_entropy(x).value, sample_entropy(scaled).value);
  EXPECT_FALSE(sample_entropy(std::vector<double>(100, 2.5)).value);
  EXPECT_FALSE(sample_entropy(std::vector<double>{0.0, 1.0, 10.0, 100.0, 1000.0}).value);
}

}  // namespace
}  // namespace isograsp::tasks::regularity_test
