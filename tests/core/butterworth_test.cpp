// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/butterworth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "tests/support/within.hpp"

namespace isograsp::butterworth_test {
namespace {

std::vector<double> sine(std::size_t count, double frequency_Hz, double rate_Hz) {
  std::vector<double> x(count);
  for (std::size_t k = 0; k < count; ++k)
    x[k] = std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(k) / rate_Hz);
  return x;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b,
                          std::size_t from, std::size_t end) {
  double largest = 0.0;
  for (std::size_t k = from; k < end; ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST(Butterworth2, CoefficientsAndStepResponseAgreeWithTheReference) {
  // Printed to 20 digits by another program; 1e-11 leaves room for the order of operations.
  constexpr double kTolerance = 1e-11;
  auto csv = CsvReader::open(ISOGRASP_SOURCE_DIR "/tests/data/golden/filter_butter2.csv");
  ASSERT_TRUE(csv) << csv.error().message();
  std::vector<double> row(csv->columns().size());
  const auto value = [&](const char* name) { return row[csv->find(name).value()]; };
  int rows = 0;
  while (*csv->next(row)) {
    ++rows;
    const double rate_Hz = value("fs_Hz");
    const LowPass2 filter = butterworth2(rate_Hz, value("fc_Hz"));
    EXPECT_WITHIN(filter.b0, value("b0"), kTolerance);
    EXPECT_WITHIN(filter.b1, value("b1"), kTolerance);
    EXPECT_WITHIN(filter.b2, value("b2"), kTolerance);
    EXPECT_WITHIN(filter.a1, value("a1"), kTolerance);
    EXPECT_WITHIN(filter.a2, value("a2"), kTolerance);
    std::vector<double> step(static_cast<std::size_t>(std::lround(0.1 * rate_Hz)) + 2, 1.0);
    step[0] = 0.0;  // the value before the step
    const auto y = filtered(filter, step);
    const auto sample = [&](double s) {
      return static_cast<std::size_t>(std::lround(s * rate_Hz));
    };
    EXPECT_WITHIN(y[1], value("step_1"), kTolerance);
    EXPECT_WITHIN(y[10], value("step_10"), kTolerance);
    EXPECT_WITHIN(y[1 + sample(0.032)], value("step_at_32ms"), kTolerance);
    EXPECT_WITHIN(y[1 + sample(0.1)], value("step_at_100ms"), kTolerance);
  }
  EXPECT_EQ(rows, 2);
}

TEST(Butterworth2, AConstantPassesUnchangedFromTheFirstSampleOn) {
  const LowPass2 filter = butterworth2(100.0, 5.0);
  const std::vector<double> x(300, -7.25);
  constexpr double kRounding = 1e-13;
  EXPECT_LT(largest_difference(filtered(filter, x), x, 0, x.size()), kRounding);
  EXPECT_LT(largest_difference(filtered_zero_phase(filter, x), x, 0, x.size()), kRounding);
}

TEST(Butterworth2, ForwardAndBackwardALineStaysTheSameLine) {
  const LowPass2 filter = butterworth2(100.0, 5.0);
  std::vector<double> x(400);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = 3.0 + 0.25 * static_cast<double>(k);
  constexpr double kForgottenStart = 1e-5;  // 1e-6 of the filter's lag on this line
  EXPECT_LT(largest_difference(filtered_zero_phase(filter, x), x, 0, x.size()), kForgottenStart);
  EXPECT_GT(largest_difference(filtered(filter, x), x, 200, 400), 0.5) << "forward alone it lags";
}

TEST(Butterworth2, ForwardAndBackwardASineKeepsItsPhaseAndLosesTheSquareOfTheGain) {
  // |H(f)|^2 = 1 / (1 + (tan(pi f / fs) / tan(pi fc / fs))^4)
  for (const double rate_Hz : {100.0, 500.0})
    for (const double frequency_Hz : {0.5, 2.0, 5.0, 10.0}) {
      const auto x = sine(static_cast<std::size_t>(20.0 * rate_Hz), frequency_Hz, rate_Hz);
      const auto y = filtered_zero_phase(butterworth2(rate_Hz, 5.0), x);
      const double ratio = std::tan(std::numbers::pi * frequency_Hz / rate_Hz) /
                           std::tan(std::numbers::pi * 5.0 / rate_Hz);
      auto expected = x;
      for (double& value : expected) value /= 1.0 + std::pow(ratio, 4.0);
      constexpr double kForgottenStart = 1e-6;
      EXPECT_LT(largest_difference(y, expected, x.size() / 4, 3 * x.size() / 4), kForgottenStart)
          << frequency_Hz << " Hz at " << rate_Hz;
    }
}

TEST(Butterworth2, TheDirectionOfTimeDoesNotMatterForwardAndBackward) {
  std::vector<double> x = sine(700, 1.7, 100.0);
  for (std::size_t k = 300; k < 420; ++k) x[k] += 2.0;
  const LowPass2 filter = butterworth2(100.0, 5.0);
  const auto y = filtered_zero_phase(filter, x);
  std::vector<double> back(x.rbegin(), x.rend());
  back = filtered_zero_phase(filter, back);
  std::reverse(back.begin(), back.end());
  constexpr double kForgottenStart = 1e-5;
  EXPECT_LT(largest_difference(y, back, 0, y.size()), kForgottenStart);
}

TEST(Butterworth2, ShortSignalsAreFilteredToo) {
  const LowPass2 filter = butterworth2(100.0, 5.0);
  EXPECT_TRUE(filtered(filter, {}).empty());
  EXPECT_TRUE(filtered_zero_phase(filter, {}).empty());
  const std::vector<double> one{4.0};
  EXPECT_DOUBLE_EQ(filtered_zero_phase(filter, one).at(0), 4.0);
}

}  // namespace
}  // namespace isograsp::butterworth_test
