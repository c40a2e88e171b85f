// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::random_test {
namespace {

constexpr int kDraws = 100000;

TEST(Random, GaussianHasMeanZeroAndStandardDeviationOne) {
  Random random(42);
  double sum = 0.0;
  double square_sum = 0.0;
  int beyond_two = 0;
  for (int n = 0; n < kDraws; ++n) {
    const double value = random.gaussian();
    EXPECT_LT(std::abs(value), 6.0);
    sum += value;
    square_sum += value * value;
    if (std::abs(value) > 2.0) ++beyond_two;
  }
  constexpr double kFiveErrors = 5.0 / 316.0;  // of a mean of kDraws
  EXPECT_WITHIN(sum / kDraws, 0.0, kFiveErrors);
  EXPECT_WITHIN(square_sum / kDraws, 1.0, kFiveErrors * std::sqrt(2.0));
  EXPECT_WITHIN(100.0 * beyond_two / kDraws, 4.55, 0.5);  // percent; five errors are 0.33
}

TEST(Random, UniformFillsTheHalfOpenUnitInterval) {
  Random random(42);
  double sum = 0.0;
  double least = 1.0;
  double most = 0.0;
  for (int n = 0; n < kDraws; ++n) {
    const double value = random.uniform();
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, 0.0);
  EXPECT_LT(most, 1.0);
  EXPECT_LT(least, 1e-3);
  EXPECT_GT(most, 1.0 - 1e-3);
  EXPECT_WITHIN(sum / kDraws, 0.5, 5.0 / 316.0 * std::sqrt(1.0 / 12.0));
}

TEST(Random, SameSeedAndStreamRepeatAndOthersDoNot) {
  Random a(7, 1), b(7, 1), other_stream(7, 2), other_seed(8, 1);
  int equal = 0;
  for (int n = 0; n < 1000; ++n) {
    const double value = a.uniform();
    EXPECT_EQ(value, b.uniform());
    if (value == other_stream.uniform() || value == other_seed.uniform()) ++equal;
  }
  EXPECT_EQ(equal, 0);
}

TEST(Random, NeighbouringSeedsAreNotCorrelated) {
  double product = 0.0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
    product += Random(seed).gaussian() * Random(seed + 1).gaussian();
  EXPECT_WITHIN(product / 1000, 0.0, 5.0 / std::sqrt(1000.0));
}

}  // namespace
}  // namespace isograsp::random_test
