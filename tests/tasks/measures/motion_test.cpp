// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/motion.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/within.hpp"

namespace isograsp::tasks::motion_test {
namespace {

constexpr double kRounding = 1e-12;

Quat turn(double angle, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(angle, axis.normalized()));
}

TEST(Motion, DistanceAndAngleAreMeansAsLongAsTheyHold) {
  const std::vector<Vec3> actual{Vec3(0.03, 0.04, 0.0), Vec3(0.0, 0.0, 0.01)};
  const std::vector<Vec3> target(2, Vec3::Zero());
  const std::vector<double> weight{1.0, 3.0};
  EXPECT_WITHIN(mean_distance(actual, target, weight).value.value(), (0.05 + 0.03) / 4.0,
                kRounding);
  const std::vector<Quat> lies{turn(0.2, Vec3(1, 2, 3)), turn(1e-9, Vec3(0, 0, 1))};
  const std::vector<Quat> level(2, Quat::Identity());
  EXPECT_WITHIN(mean_angle(lies, level, weight).value.value(), (0.2 + 3e-9) / 4.0, kRounding);
  EXPECT_EQ(english(mean_distance({}, {}, {}).reason), "no samples");
  EXPECT_EQ(english(mean_angle({}, {}, {}).reason), "no samples");
}

TEST(Motion, TurningAboutTheMainAxisIsSeenByTheAttitudeOnly) {
  const Vec3 axis(0.0, 0.0, 2.0);
  const Quat spun = turn(0.7, axis);
  EXPECT_WITHIN(axis_angle(spun, Quat::Identity(), axis), 0.0, kRounding);
  EXPECT_WITHIN(angle_between(spun, Quat::Identity()), 0.7, kRounding);
  // Tilted and then spun: the axis knows the tilt alone.
  EXPECT_WITHIN(axis_angle(turn(0.3, Vec3::UnitX()) * spun, Quat::Identity(), axis), 0.3,
                kRounding);
}

TEST(Motion, AnAxisIsNeverFurtherOffThanTheAttitudeAndDoesNotCareForTheWorldFrame) {
  const Quat world = turn(2.0, Vec3(1, -1, 0.5));
  const Vec3 axis(1.0, 0.5, 0.0);
  for (double angle = 0.1; angle < 3.1; angle += 0.3) {
    const Quat a = turn(angle, Vec3(0.2, 1.0, angle));
    const Quat b = turn(0.5, Vec3(1.0, 0.0, 1.0));
    EXPECT_LE(axis_angle(a, b, axis), angle_between(a, b) + kRounding);
    EXPECT_WITHIN(axis_angle(world * a, world * b, axis), axis_angle(a, b, axis), kRounding);
  }
}

TEST(Motion, ASymmetricObjectUpsideDownLiesAsItShould) {
  const std::vector<Quat> over{turn(std::numbers::pi - 0.1, Vec3::UnitX())};
  const std::vector<Quat> level{Quat::Identity()};
  const std::vector<double> weight{0.01};
  const Vec3 z = Vec3::UnitZ();
  EXPECT_WITHIN(mean_axis_angle(over, level, z, weight).value.value(), std::numbers::pi - 0.1,
                kRounding);
  EXPECT_WITHIN(mean_axis_angle(over, level, z, weight, true).value.value(), 0.1, kRounding);
}

TEST(Motion, TiltWeighsLargeAnglesMoreAndIsTheAngleIfThatIsConstant) {
  const std::vector<Quat> tilted{turn(0.1, Vec3(1, 1, 0)), turn(0.7, Vec3(0, 1, 2))};
  const std::vector<Quat> level(2, Quat::Identity());
  const std::vector<double> weight{3.0, 1.0};
  EXPECT_WITHIN(rms_angle(tilted, level, weight).value.value(),
                std::sqrt((3.0 * 0.1 * 0.1 + 0.7 * 0.7) / 4.0), kRounding);
  const std::vector<Quat> constant(2, turn(0.3, Vec3::UnitX()));
  EXPECT_WITHIN(rms_angle(constant, level, weight).value.value(), 0.3, kRounding);
  EXPECT_EQ(english(rms_angle({}, {}, {}).reason), "no samples");
}

TEST(Motion, AStraightPathIsEfficientADetourCostsItsLength) {
  const std::vector<Vec3> straight{Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.4, 0, 0)};
  const std::vector<Vec3> corner{Vec3(1, 1, 1), Vec3(1.3, 1, 1), Vec3(1.3, 1, 1.4)};
  using Ways = std::vector<std::vector<Vec3>>;
  EXPECT_WITHIN(path_efficiency(Ways{straight}).value.value(), 100.0, 100.0 * kRounding);
  EXPECT_WITHIN(path_length(corner), 0.7, kRounding);
  EXPECT_WITHIN(path_efficiency(Ways{corner}).value.value(), 100.0 * 0.5 / 0.7, 100.0 * kRounding);
  // A long way counts more than a short one; the jump from one to the next does not count.
  EXPECT_WITHIN(path_efficiency(Ways{straight, {}, corner}).value.value(),
                100.0 * (0.4 + 0.5) / (0.4 + 0.7), 100.0 * kRounding);
  EXPECT_EQ(english(path_efficiency(Ways{std::vector<Vec3>(3, Vec3::Zero())}).reason),
            "nothing moved");
  EXPECT_EQ(english(path_efficiency({}).reason), "nothing moved");
  EXPECT_EQ(path_length(std::vector<Vec3>{}), 0.0);
}

}  // namespace
}  // namespace isograsp::tasks::motion_test
