// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/coordination/direction.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/support/within.hpp"

namespace isograsp::tasks::direction_test {
namespace {

constexpr double kRounding = 1e-12;

TEST(Direction, AnglesFromTinyToOppositeAreExact) {
  for (const double angle : {0.0, 1e-12, 1e-4, 1.0, 3.0, std::numbers::pi}) {
    const Vec3 turned = 7.0 * Vec3(std::sin(angle), 0.0, std::cos(angle));
    EXPECT_WITHIN(angle_of(turned, Vec3(0.0, 0.0, 0.1)), angle, 1e-15 + kRounding * angle);
  }
}

TEST(Direction, ErrorIsTheMeanAngleAsLongAsItHoldsAndOnlyWhereThereIsForce) {
  const std::vector<Vec3> force{Vec3(0.0, 0.0, 5.0), Vec3(0.0, 3.0, 3.0), Vec3(0.01, 0.0, 0.0)};
  const std::vector<double> weight{1.0, 3.0, 10.0};
  const Vec3 target(0.0, 0.0, 2.0);
  EXPECT_WITHIN(direction_error(force, target, weight, 0.1).value.value(),
                0.75 * std::numbers::pi / 4.0, kRounding);
  EXPECT_EQ(english(direction_error(force, target, weight, 10.0).reason), "there was no force");
}

TEST(Direction, TurningHandAndTargetTogetherOrPressingHarderChangesNothing) {
  Random random(8);
  std::vector<Vec3> force;
  for (int k = 0; k < 50; ++k)
    force.push_back(Vec3(random.gaussian(), random.gaussian(), 4.0 + random.gaussian()));
  const std::vector<double> weight(50, 0.01);
  const Vec3 target(0.3, -0.2, 1.0);
  const Quat turn(Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -0.5).normalized()));
  auto turned = force;
  for (Vec3& f : turned) f = 3.0 * (turn * f);
  EXPECT_WITHIN(direction_error(turned, turn * target, weight).value.value(),
                direction_error(force, target, weight).value.value(), kRounding);
  EXPECT_WITHIN(projection_ratio(turned, turn * target, weight).value.value(),
                projection_ratio(force, target, weight).value.value(), kRounding);
}

TEST(Direction, ProjectionOfASteadyForceIsTheCosineOfItsError) {
  const std::vector<double> weight{0.01, 0.02};
  for (const double angle : {0.0, 0.4, 2.0}) {
    const Vec3 f(std::sin(angle), 0.0, std::cos(angle));
    const std::vector<Vec3> force{2.0 * f, 9.0 * f};
    EXPECT_WITHIN(projection_ratio(force, Vec3::UnitZ(), weight).value.value(), std::cos(angle),
                  kRounding);
  }
  EXPECT_FALSE(projection_ratio(std::vector<Vec3>(2, Vec3::Zero()), Vec3::UnitZ(), weight).value);
}

TEST(Direction, AStraightForcePathHasNoDeviationWhereverItStarts) {
  std::vector<std::vector<double>> digits(3);
  for (int k = 0; k <= 10; ++k) {
    digits[0].push_back(1.0 + 0.3 * k);
    digits[1].push_back(2.0 - 0.1 * k);
    digits[2].push_back(0.7);
  }
  const std::vector<double> weight(11, 0.01);
  EXPECT_WITHIN(path_deviation(digits, weight).value.value(), 0.0, kRounding);
}

TEST(Direction, PressingOneDigitAfterTheOtherLeavesTheLineByTheHeightOfItsTriangle) {
  // (0, 0) -> (3, 0) -> (3, 4): the corner lies 12/5 from the line.
  const std::vector<std::vector<double>> digits{{1.0, 4.0, 4.0}, {2.0, 2.0, 6.0}};
  EXPECT_WITHIN(path_deviation(digits, std::vector<double>{1.0, 2.0, 1.0}).value.value(),
                2.0 / 4.0 * 12.0 / 5.0, kRounding);
  const std::vector<std::vector<double>> back{{1.0, 4.0, 1.0}};
  EXPECT_EQ(english(path_deviation(back, std::vector<double>{1.0, 1.0, 1.0}).reason),
            "the force ends where it began");
}

TEST(Direction, NetPushIsRelativeToTheGripOfTheSameMoment) {
  const std::vector<double> push{1.0, 3.0, 10.0, 5.0};
  const std::vector<double> grip{10.0, 10.0, 20.0, 0.0};
  const std::vector<double> weight{2.0, 1.0, 1.0, 9.0};
  const PushSummary found = summary_of_push(push, grip, weight);
  EXPECT_DOUBLE_EQ(found.median.value.value(), 10.0);
  EXPECT_DOUBLE_EQ(found.above_20.value.value(), 50.0);
  EXPECT_EQ(english(summary_of_push(push, grip, weight, 30.0).median.reason), "there was no grip");
}

}  // namespace
}  // namespace isograsp::tasks::direction_test
