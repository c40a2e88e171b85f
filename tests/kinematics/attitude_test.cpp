// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinematics/attitude.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "kinematics/pose_series.hpp"
#include "tests/kinematics/support.hpp"
#include "tests/support/within.hpp"

namespace isograsp::attitude_test {
namespace {

using namespace isograsp::test;

constexpr double kPi = std::numbers::pi;
constexpr double kExact_rad = 1e-14;

Quat about(const Vec3& axis, double angle) {
  return Quat(Eigen::AngleAxisd(angle, axis));
}

TEST(Attitude, AnglesBuildTheAttitudeAgainAlsoAtAndNearTheLock) {
  constexpr double kBuilt_rad = 1e-8;  // at the lock the angles keep what the quaternion has
  for (const auto sequence : {AngleSequence::rpy, AngleSequence::zxy})
    for (const double middle : {-kPi / 2, -kPi / 2 + 1e-9, -kPi / 2 + 1e-5, -0.4, 0.0, 1e-8, 1.2,
                                kPi / 2 - 1e-5, kPi / 2 - 1e-9, kPi / 2})
      for (const double outer : {-3.0, -0.2, 0.0, 2.0}) {
        const Quat q = attitude_of({outer, middle, 0.7}, sequence);
        const Vec3 angles = angles_of(q, sequence);
        EXPECT_WITHIN(angle_between(attitude_of(angles, sequence), q), 0.0, kBuilt_rad) << middle;
        EXPECT_LE(std::abs(angles[1]), kPi / 2);
      }
}

TEST(Attitude, AnglesTurnAboutTheAxesOfTheirSequence) {
  const Vec3 angles(0.3, -0.4, 0.7);
  const auto turn = [](const Vec3& axis, double rad) {
    return about(axis, rad).toRotationMatrix();
  };
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Mat3 rpy = turn(z, 0.7) * turn(y, -0.4) * turn(x, 0.3);
  const Mat3 zxy = turn(z, 0.3) * turn(x, -0.4) * turn(y, 0.7);
  EXPECT_WITHIN((attitude_of(angles, AngleSequence::rpy).toRotationMatrix() - rpy).norm(), 0.0,
                kExact_rad);
  EXPECT_WITHIN((attitude_of(angles, AngleSequence::zxy).toRotationMatrix() - zxy).norm(), 0.0,
                kExact_rad);
}

TEST(Attitude, AtTheLockTheInnermostTurnIsZero) {
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(angles_of(attitude_of({0.3, sign * kPi / 2, 0.7}, AngleSequence::rpy),
                        AngleSequence::rpy)[0],
              0.0);
    EXPECT_EQ(angles_of(attitude_of({0.3, sign * kPi / 2, 0.7}, AngleSequence::zxy),
                        AngleSequence::zxy)[2],
              0.0);
  }
}

TEST(Attitude, ARotationVectorIsExactForTheSmallestAndTheLargestAngles) {
  const Vec3 axis = Vec3(1, -2, 2) / 3.0;
  for (const double angle : {0.0, 1e-12, 1e-8, 0.5, kPi - 1e-9, kPi}) {
    const Quat q = about(axis, angle);
    for (const Quat& same : {q, Quat(-q.w(), -q.x(), -q.y(), -q.z())}) {
      const Vec3 phi = rotation_vector(same);
      EXPECT_WITHIN(phi.norm(), angle, kExact_rad);
      if (angle < kPi) {
        EXPECT_WITHIN((phi - angle * axis).norm(), 0.0, kExact_rad);
      }
    }
  }
}

TEST(Attitude, SignsAreCanonicalFirstAndThenContinuous) {
  EXPECT_EQ(canonical(Quat(-0.5, 0.5, 0.5, 0.5)).w(), 0.5);
  EXPECT_EQ(canonical(Quat(0, 0, -0.6, 0.8)).y(), 0.6);
  Quat last = missing_pose().q;
  for (int step = 0; step <= 720; step += 5) {
    const Quat q = canonical(about(Vec3::UnitZ(), step * kPi / 180.0));
    const Quat next = continued(q, last);
    if (step > 0) {
      EXPECT_GT(next.dot(last), 0.99) << step;
    }
    last = next;
  }
}

TEST(Attitude, AMeanDoesNotDependOnSignsNorOnTheFrameThatLooks) {
  Random random(4);
  const Quat centre = random_attitude(random);
  const Quat turn = random_attitude(random);
  MeanAttitude mean, signs, turned;
  for (int i = 0; i < 50; ++i) {
    const Quat q = centre * about(random_vector(random, 1.0).normalized(), 0.2 * random.uniform());
    mean.add(q);
    signs.add(i % 2 == 0 ? q : Quat(-q.w(), -q.x(), -q.y(), -q.z()));
    turned.add(turn * q);
  }
  constexpr double kMean_rad = 1e-12;  // rounding of fifty products
  EXPECT_WITHIN(angle_between(mean.mean(), signs.mean()), 0.0, kMean_rad);
  EXPECT_WITHIN(angle_between(turn * mean.mean(), turned.mean()), 0.0, kMean_rad);
  EXPECT_LT(angle_between(mean.mean(), centre), 0.1);
}

TEST(Attitude, MirroringTwiceChangesNothingAndComposesLikeTheWorld) {
  Random random(5);
  const Pose X_AB = random_pose(random);
  const Pose X_BC = random_pose(random);
  const Pose twice = mirrored(mirrored(X_AB));
  EXPECT_EQ(twice.p, X_AB.p);
  EXPECT_EQ(twice.q.coeffs(), X_AB.q.coeffs());
  const Pose image = mirrored(compose(X_AB, X_BC));
  const Pose of_images = compose(mirrored(X_AB), mirrored(X_BC));
  EXPECT_WITHIN((image.p - of_images.p).norm(), 0.0, kExact_rad);
  EXPECT_WITHIN(angle_between(image.q, of_images.q), 0.0, kExact_rad);
}

TEST(Attitude, UnwrappingTakesTheShorterWay) {
  EXPECT_WITHIN(unwrapped(-3.0, 3.0), 2.0 * kPi - 3.0, kExact_rad);
  EXPECT_WITHIN(unwrapped(3.0, -3.0), 3.0 - 2.0 * kPi, kExact_rad);
  EXPECT_WITHIN(unwrapped(-kPi, 0.0), kPi, kExact_rad) << "a step is in (-pi, pi]";
}

}  // namespace
}  // namespace isograsp::attitude_test
