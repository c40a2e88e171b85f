// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/percentile.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::statistics::percentile_test {
namespace {

TEST(Percentile, IsTheValueAtItsShareOfTheWayFromTheFirstToTheLast) {
  const std::vector<double> x{40.0, 10.0, 30.0, 20.0};  // sorted: positions 0, 1, 2, 3
  EXPECT_DOUBLE_EQ(percentile(x, 0.0).value.value(), 10.0);
  EXPECT_DOUBLE_EQ(percentile(x, 100.0).value.value(), 40.0);
  EXPECT_DOUBLE_EQ(percentile(x, 50.0).value.value(), 25.0);
  EXPECT_DOUBLE_EQ(percentile(x, 25.0).value.value(), 17.5);
  EXPECT_DOUBLE_EQ(percentile(x, 95.0).value.value(), 38.5);
  EXPECT_DOUBLE_EQ(median(std::vector<double>{5.0, -1.0, 2.0}).value.value(), 2.0);
}

TEST(Percentile, OfEquidistantValuesIsLinearInThePercent) {
  std::vector<double> x;
  for (int k = 0; k <= 200; ++k) x.push_back(0.5 * ((k * 37) % 201));  // a permutation
  for (const double percent : {0.0, 1.0, 33.3, 50.0, 95.0, 99.9, 100.0})
    EXPECT_WITHIN(percentile(x, percent).value.value(), percent, 1e-12);
}

TEST(Percentile, OneValueIsAllItsPercentilesAndNoneHasNone) {
  EXPECT_EQ(percentile(std::vector<double>{3.0}, 95.0).value, 3.0);
  EXPECT_FALSE(percentile({}, 50.0).value);
}

TEST(Percentile, BetweenTheLargestNumbersOfEitherSignIsANumber) {
  EXPECT_WITHIN(*percentile(std::vector{-1.7e308, 1.7e308}, 75.0).value / 1e307, 8.5, 1e-12);
}

}  // namespace
}  // namespace isograsp::statistics::percentile_test
