// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/holm.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::statistics::holm_test {
namespace {

using P = std::vector<std::optional<double>>;
constexpr double kRounding = 1e-15;  // one product of numbers below 1

TEST(Holm, MultipliesTheSmallestByTheirNumberAndNeverFalls) {
  const auto adjusted = holm(P{0.04, 0.01, 0.03, 0.005});
  EXPECT_WITHIN(adjusted[3].value(), 0.02, kRounding);  // 4 x 0.005
  EXPECT_WITHIN(adjusted[1].value(), 0.03, kRounding);  // 3 x 0.01
  EXPECT_WITHIN(adjusted[2].value(), 0.06, kRounding);  // 2 x 0.03
  EXPECT_WITHIN(adjusted[0].value(), 0.06, kRounding);  // not 0.04: never below the one before
}

TEST(Holm, IsAtMostOneAndPassesByWhatGaveNoValue) {
  const auto adjusted = holm(P{0.9, std::nullopt, 0.7});
  EXPECT_EQ(adjusted[0], 1.0);
  EXPECT_FALSE(adjusted[1]);
  EXPECT_EQ(adjusted[2], 1.0);
  EXPECT_EQ(holm(P{0.2, std::nullopt})[0], 0.2) << "one test alone is not corrected";
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace isograsp::statistics::holm_test
