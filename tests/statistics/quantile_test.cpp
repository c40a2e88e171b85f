// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/quantile.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace isograsp::statistics::quantile_test {
namespace {

TEST(Quantile, EqualWeightsGiveTheSortedValueOfThatRank) {
  Random random(2);
  for (const std::size_t count : {1u, 2u, 10u, 101u}) {
    std::vector<double> x;
    for (std::size_t k = 0; k < count; ++k) x.push_back(std::round(20.0 * random.gaussian()));
    auto sorted = x;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t rank = 1; rank <= count; ++rank)
      EXPECT_EQ(quantile(x, std::vector<double>(count, 0.01),
                         static_cast<double>(rank) / static_cast<double>(count))
                    .value,
                sorted[rank - 1]);
  }
}

TEST(Quantile, AValueCountsAsLongAsItHolds) {
  const std::vector<double> x{3.0, 1.0, 2.0};
  const std::vector<double> weight{1.0, 1.0, 8.0};
  EXPECT_EQ(quantile(x, weight, 0.10).value, 1.0);
  EXPECT_EQ(quantile(x, weight, 0.11).value, 2.0);
  EXPECT_EQ(quantile(x, weight, 0.90).value, 2.0);
  EXPECT_EQ(quantile(x, weight, 0.91).value, 3.0);
  EXPECT_EQ(english(quantile({}, {}, 0.5).reason), "no samples");
  EXPECT_FALSE(quantile(x, std::vector<double>(3, 0.0), 0.5).value);
}

}  // namespace
}  // namespace isograsp::statistics::quantile_test
