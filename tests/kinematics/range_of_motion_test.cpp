// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/range_of_motion.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "kinematics/attitude.hpp"
#include "tests/support/within.hpp"

namespace isograsp::range_of_motion_test {
namespace {

constexpr double kExact_rad = 1e-12;

TEST(RangeOfMotion, OneBadRowIsNoHeldRange) {
  std::vector<double> t_s, angle;
  for (int k = 0; k <= 100; ++k) {
    t_s.push_back(k * 0.01);
    angle.push_back(k == 50 ? 2.0 : 0.5);
  }
  const Range range = range_of_motion(t_s, angle);
  EXPECT_EQ(*range.max_rad, 2.0);
  EXPECT_WITHIN(*range.max_held_rad, 0.5 + 1.5 / 21.0, kExact_rad);
  EXPECT_WITHIN(*range.min_held_rad, 0.5, kExact_rad);
}

TEST(RangeOfMotion, AWindowWithAMissingRowOrBeyondTheRecordDoesNotCount) {
  std::vector<double> t_s, angle;
  for (int k = 0; k <= 40; ++k) {
    t_s.push_back(k * 0.01);
    angle.push_back(k == 20 ? kMissing : 0.01 * k);
  }
  const Range range = range_of_motion(t_s, angle);
  EXPECT_EQ(*range.min_rad, 0.0);
  EXPECT_EQ(*range.max_rad, 0.4);
  EXPECT_FALSE(range.min_held_rad) << "every window of 0.2 s in 0.4 s meets the row in the middle";
  const Range nothing = range_of_motion(t_s, std::vector<double>(t_s.size(), kMissing));
  EXPECT_FALSE(nothing.min_rad);
  EXPECT_FALSE(range_of_motion({}, {}).max_rad);
}

}  // namespace
}  // namespace isograsp::range_of_motion_test
