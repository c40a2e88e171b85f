// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/line.hpp"

#include <gtest/gtest.h>

#include "tests/support/within.hpp"
#include "tests/tasks/samples.hpp"

namespace isograsp::statistics::line_test {
namespace {

TEST(Line, ALineIsFoundExactlyAtIrregularTimesToo) {
  const std::vector<double> t{0.0, 0.1, 0.5, 2.0, 2.1};
  const auto line = fit_line(t, test::sampled(t, [](double s) { return 4.0 - 1.5 * s; }));
  constexpr double kRounding = 1e-14;
  ASSERT_TRUE(line);
  EXPECT_WITHIN(line->slope, -1.5, kRounding);
  EXPECT_WITHIN(line->mean - line->slope * line->t_mean_s, 4.0, kRounding);
  EXPECT_WITHIN(line->residual_sd, 0.0, kRounding);
}

TEST(Line, TheDeviationIsThatOfTheResiduals) {
  const std::vector<double> t{0.0, 1.0, 2.0, 3.0};
  const auto line = fit_line(t, std::vector<double>{1.0, -1.0, -1.0, 1.0});
  ASSERT_TRUE(line);
  EXPECT_DOUBLE_EQ(line->slope, 0.0);
  EXPECT_DOUBLE_EQ(line->residual_sd, std::sqrt(4.0 / 3.0));
  EXPECT_FALSE(fit_line(std::vector<double>{0.0, 1.0}, std::vector<double>{0.0, 1.0}));
}

}  // namespace
}  // namespace isograsp::statistics::line_test
