// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ties.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace isograsp::ties_test {
namespace {

using Ranks = std::vector<double>;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(MidRanks, ShareTheMeanOfTheirRanksAndReachFromTheSmallestOn) {
  EXPECT_EQ(mid_ranks(Ranks{3.0, 1.0, 3.0, 2.0}, 0.0), (Ranks{3.5, 1.0, 3.5, 2.0}));
  EXPECT_EQ(mid_ranks(Ranks{}, 1.0), Ranks{});
  // 0 and 1 are tied, 2 is too far from 0.
  EXPECT_EQ(mid_ranks(Ranks{0.0, 1.0, 2.0}, 1.0), (Ranks{1.5, 1.5, 3.0}));
}

TEST(MidRanks, WhatNeverCameIsTiedAsTheLongest) {
  EXPECT_EQ(mid_ranks(Ranks{kInfinity, 2.0, kInfinity, 1.0}, 1e-6), (Ranks{3.5, 2.0, 3.5, 1.0}));
}

TEST(Ties, AreRelativeToTheLargestAndKnowInfinities) {
  EXPECT_EQ(tie_width(Ranks{-12.0, 3.0, kInfinity}), 12.0 * kTied);
  EXPECT_EQ(tie_width(Ranks{}), 0.0);
  EXPECT_TRUE(are_tied(12.0, 12.000000000000002));
  EXPECT_FALSE(are_tied(12.0, 12.0000001));
  EXPECT_TRUE(are_tied(kInfinity, kInfinity, 0.0));
  EXPECT_FALSE(are_tied(kInfinity, 1.0, 1e300));
  EXPECT_TRUE(are_tied(0.0, -0.0));
}

}  // namespace
}  // namespace isograsp::ties_test
