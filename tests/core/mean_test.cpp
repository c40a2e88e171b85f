// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mean.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace isograsp::mean_test {
namespace {

constexpr double kLargest = std::numeric_limits<double>::max();

TEST(ArithmeticMean, OfOrdinaryValuesIsTheirSumByTheirNumberToTheBit) {
  Random random(3);
  for (int n = 1; n < 40; ++n) {
    std::vector<double> values;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += values.emplace_back(random.gaussian());
    EXPECT_EQ(arithmetic_mean(values), sum / n);
  }
}

TEST(ArithmeticMean, IsANumberWhereTheSumIsNone) {
  EXPECT_EQ(arithmetic_mean(std::vector{kLargest, kLargest}), kLargest);
  EXPECT_EQ(arithmetic_mean(std::vector(7, -kLargest)), -kLargest);
  EXPECT_DOUBLE_EQ(arithmetic_mean(std::vector{1e308, 1.2e308, 1.4e308}), 1.2e308);
  EXPECT_DOUBLE_EQ(arithmetic_mean(std::vector{1e308, 1e308, -1e308, -1e308, 1e308}), 2e307);
}

}  // namespace
}  // namespace isograsp::mean_test
