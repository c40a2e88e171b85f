// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fourier.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::fourier_test {
namespace {

TEST(Fourier, TheTransformIsTheDefinitionAndKeepsEnergy) {
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
    EXPECT_WITHIN(std::abs(fast[k] - slow), 0.0, kRounding);
    energy += std::norm(x[k]);
    spectral_energy += std::norm(fast[k]) / 64.0;
  }
  EXPECT_WITHIN(energy, spectral_energy, kRounding);
}

std::vector<double> noise(std::size_t count) {
  Random random(7);
  std::vector<double> x(count);
  for (double& value : x) value = random.gaussian() + 1.0;
  return x;
}

TEST(Fourier, LinesOfARealSignalAreThoseOfTheComplexTransform) {
  constexpr double kRounding = 1e-11;
  for (const std::size_t length : {2u, 4u, 8u, 64u, 1024u})
    for (const std::size_t count : {length, length / 2 + 1, std::size_t{1}}) {
      const auto x = noise(count);
      std::vector<std::complex<double>> whole(length);
      std::copy(x.begin(), x.end(), whole.begin());
      fourier_transform(whole);
      const auto lines = RealFourier(length)(x);
      ASSERT_EQ(lines.size(), length / 2 + 1);
      for (std::size_t k = 0; k < lines.size(); ++k)
        EXPECT_WITHIN(std::abs(lines[k] - whole[k]), 0.0, kRounding) << length << ", line " << k;
    }
}

TEST(Fourier, LowLinesAreThoseOfTheWholeTransformHoweverFewOrManyAreAsked) {
  constexpr double kFiltered =
      1e-11;  // the rounding of the filter, raised by dividing by its slope
  for (const std::size_t count : {3u, 100u, 1000u, 1024u})
    for (const std::size_t length : {1024u, 4096u, 16384u}) {
      const auto x = noise(count);
      const auto lines = RealFourier(length)(x);
      double largest = 0.0;
      for (const auto& line : lines) largest = std::max(largest, std::abs(line));
      for (const std::size_t last : {std::size_t{0}, length / 100, length / 11, length / 2}) {
        const auto low = low_magnitudes(x, length, last);
        ASSERT_EQ(low.size(), last + 1);
        for (std::size_t k = 0; k <= last; ++k)
          ASSERT_WITHIN(low[k], std::abs(lines[k]), kFiltered * largest)
              << count << " in " << length << ", line " << k << " of " << last;
      }
    }
}

}  // namespace
}  // namespace isograsp::fourier_test
