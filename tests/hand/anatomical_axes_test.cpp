// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand/anatomical_axes.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.hpp"

namespace isograsp::anatomical_axes_test {
namespace {

constexpr std::array<Hand, 2> kHands{Hand::right, Hand::left};

/// Contact frame of a finger in the world, from the geometry of the device alone: normal and
/// tangent of the right hand, the left hand's turned by pi about the vertical.
Mat3 contact_frame(Finger finger, Hand hand) {
  const Vec3 normal = (finger == Finger::thumb ? 1.0 : -1.0) * Vec3::UnitX();
  Mat3 R_WC = Mat3::Identity();
  R_WC << Vec3::UnitY(), normal.cross(Vec3::UnitY()), normal;
  if (hand == Hand::left) R_WC = Vec3(-1.0, 1.0, -1.0).asDiagonal() * R_WC;
  return R_WC;
}

Mat3 matrix_of(Finger finger, Hand hand) {
  Mat3 m = Mat3::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) m.col(i) = anatomical(Mat3::Identity().col(i), finger, hand);
  return m;
}

Vec3 random_force(Random& random) {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return {x, y, random.gaussian()};
}

TEST(AnatomicalAxes, AMirroredPushOfTheOtherHandHasTheSameComponents) {
  Random random(1);
  const Vec3 mirror(-1.0, 1.0, 1.0);  // in the plane between the two halves of the body
  for (int k = 0; k < 100; ++k)
    for (const Finger finger : kFingers) {
      const Vec3 force_W = random_force(random);
      const Vec3 mirrored_W = mirror.asDiagonal() * force_W;
      const Vec3 right_C = contact_frame(finger, Hand::right).transpose() * force_W;
      const Vec3 left_C = contact_frame(finger, Hand::left).transpose() * mirrored_W;
      EXPECT_EQ(anatomical(right_C, finger, Hand::right), anatomical(left_C, finger, Hand::left));
    }
}

TEST(AnatomicalAxes, RadialIsUpAndDistalIsTowardsTheScreenForEveryFingerOfBothHands) {
  for (const Hand hand : kHands)
    for (const Finger finger : kFingers) {
      const Mat3 R_CW = contact_frame(finger, hand).transpose();
      EXPECT_EQ(anatomical(R_CW * Vec3::UnitY(), finger, hand), Vec3(0.0, 1.0, 0.0));
      EXPECT_EQ(anatomical(R_CW * -Vec3::UnitZ(), finger, hand), Vec3(0.0, 0.0, 1.0));
    }
}

TEST(AnatomicalAxes, PressingIsFlexionAndPullingExtensionOfEveryFinger) {
  for (const Hand hand : kHands)
    for (const Finger finger : kFingers) {
      EXPECT_EQ(anatomical(Vec3(0.0, 0.0, 5.0), finger, hand), Vec3(5.0, 0.0, 0.0));
      EXPECT_EQ(anatomical(Vec3(0.0, 0.0, -5.0), finger, hand), Vec3(-5.0, 0.0, 0.0));
    }
}

TEST(AnatomicalAxes, SizesAndAnglesStayAndOneHandTurnsWhereTheOtherReflects) {
  for (const Finger finger : kFingers) {
    for (const Hand hand : kHands) {
      const Mat3 m = matrix_of(finger, hand);
      EXPECT_EQ(m * m.transpose(), Mat3::Identity());
      EXPECT_EQ(m.determinant(), distal_sign(finger, hand));
    }
    EXPECT_EQ(distal_sign(finger, Hand::left), -distal_sign(finger, Hand::right));
  }
  EXPECT_EQ(distal_sign(Finger::index, Hand::right), 1.0);
  EXPECT_EQ(distal_sign(Finger::middle, Hand::right), 1.0);
  EXPECT_EQ(distal_sign(Finger::thumb, Hand::right), -1.0);
}

TEST(AnatomicalAxes, NoForceIsZeroWithoutASign) {
  for (const Hand hand : kHands)
    for (const Finger finger : kFingers)
      EXPECT_FALSE(std::signbit(anatomical(Vec3::Zero(), finger, hand).z()));
}

TEST(AnatomicalAxes, ColumnsAreAddedOfFingersThatAreThereAndMissingValuesStayMissing) {
  const double missing = std::numeric_limits<double>::quiet_NaN();
  Signals signals({"t_s", "thumb_fx_N", "thumb_fy_N", "thumb_fz_N", "index_fz_N"});
  signals.append_row(std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0});
  signals.append_row(std::vector<double>{0.1, 1.0, missing, 3.0, 4.0});
  add_anatomical_forces(signals, Hand::right);
  const std::vector<std::string> names{
      "t_s",        "thumb_fx_N",      "thumb_fy_N",     "thumb_fz_N",
      "index_fz_N", "thumb_flexion_N", "thumb_radial_N", "thumb_distal_N"};
  EXPECT_EQ(signals.names(), names);
  EXPECT_EQ(signals.column("thumb_flexion_N")[0], 3.0);
  EXPECT_EQ(signals.column("thumb_radial_N")[0], 1.0);
  EXPECT_EQ(signals.column("thumb_distal_N")[0], -2.0);
  EXPECT_EQ(signals.column("thumb_flexion_N")[1], 3.0);
  EXPECT_TRUE(std::isnan(signals.column("thumb_distal_N")[1]));
  add_anatomical_forces(signals, Hand::left);
  EXPECT_EQ(signals.names(), names) << "what is there is not replaced";
}

}  // namespace
}  // namespace isograsp::anatomical_axes_test
