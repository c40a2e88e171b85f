// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/force_sense.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::tasks::force_sense_test {
namespace {

TEST(ForceSense, BiasAndScatterAreToldApart) {
  const std::vector<double> target{8.0, 8.0, 4.0};
  const ForceSense biased = force_sense(target, std::vector<double>{9.5, 9.5, 5.5});
  EXPECT_DOUBLE_EQ(biased.constant_error.value.value(), 1.5);
  EXPECT_DOUBLE_EQ(biased.absolute_error.value.value(), 1.5);
  EXPECT_DOUBLE_EQ(biased.variable_error.value.value(), 0.0);
  const ForceSense scattered = force_sense(target, std::vector<double>{10.0, 6.0, 4.0});
  EXPECT_DOUBLE_EQ(scattered.constant_error.value.value(), 0.0);
  EXPECT_DOUBLE_EQ(scattered.absolute_error.value.value(), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(scattered.variable_error.value.value(), 2.0);
}

TEST(ForceSense, MeanSquareIsBiasSquaredPlusScatterSquared) {
  const std::vector<double> target{3.0, 5.0, 4.0, 6.0};
  const std::vector<double> reproduced{3.2, 6.1, 3.7, 6.9};
  const ForceSense found = force_sense(target, reproduced);
  double mean_square = 0.0;
  for (std::size_t k = 0; k < 4; ++k) mean_square += std::pow(reproduced[k] - target[k], 2.0) / 4.0;
  const double variance = std::pow(*found.variable_error.value, 2.0) * 3.0 / 4.0;
  EXPECT_WITHIN(mean_square, std::pow(*found.constant_error.value, 2.0) + variance, 1e-14);
}

TEST(ForceSense, OneRepetitionHasNoScatterAndNoneNothing) {
  const ForceSense one = force_sense(std::vector<double>{4.0}, std::vector<double>{3.0});
  EXPECT_EQ(one.constant_error.value, -1.0);
  EXPECT_EQ(one.absolute_error.value, 1.0);
  EXPECT_FALSE(one.variable_error.value);
  EXPECT_FALSE(force_sense({}, {}).constant_error.value);
}

}  // namespace
}  // namespace isograsp::tasks::force_sense_test
