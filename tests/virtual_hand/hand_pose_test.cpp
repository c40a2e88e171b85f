// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/hand_pose.hpp"

#include <gtest/gtest.h>

#include "kinematics/attitude.hpp"
#include "tests/support/every.hpp"
#include "tests/support/no_alloc.hpp"
#include "tests/support/random_pose.hpp"
#include "tests/support/within.hpp"
#include "tests/virtual_hand/support.hpp"

namespace isograsp::hand_pose_test {
namespace {

using namespace isograsp::test;
using namespace isograsp::virtual_hand;

/// Chains of a few rotations and sums of metres: some units of the last place.
constexpr double kExact = 1e-14;

HandPose random_hand_pose(Random& random) {
  HandPose pose;
  pose.X_WP = random_pose(random);
  for (DigitAngles& digit : pose.angles)
    for (double& angle_rad : digit) angle_rad = 2.0 * random.uniform() - 0.7;
  return pose;
}

TEST(HandPose, JointsAreThoseOfTheIndependentOracle) {
  std::map<std::string, std::array<Pose, kHandJointCount>> poses;
  for (const Fields& row : every(golden_table(hand_data("fk_poses.csv"))))
    poses[row.at("id")] = joint_poses(
        hand_in_space(golden_hand(row.at("hand")),
                      {{three_in(row, "", "_m"), quaternion_in(row, "q")}, angles_in(row)}));
  for (const Fields& row : every(golden_table(hand_data("fk_joints.csv")))) {
    const auto name = std::find(kHandJointNames.begin(), kHandJointNames.end(), row.at("joint"));
    ASSERT_NE(name, kHandJointNames.end());
    const Pose& X =
        poses.at(row.at("id"))[static_cast<std::size_t>(name - kHandJointNames.begin())];
    EXPECT_WITHIN((X.p - three_in(row, "", "_m")).norm(), 0.0, kExact) << row.at("id") << *name;
    EXPECT_WITHIN(angle_between(X.q, quaternion_in(row, "q")), 0.0, 10.0 * kExact)
        << row.at("id") << *name;
  }
}

TEST(HandPose, JacobiansOfTheTipsAreThoseOfTheIndependentOracle) {
  std::map<std::string, HandInSpace> hands;
  for (const Fields& row : every(golden_table(hand_data("fk_poses.csv"))))
    hands[row.at("id")] =
        hand_in_space(golden_hand(row.at("hand")),
                      {{three_in(row, "", "_m"), quaternion_in(row, "q")}, angles_in(row)});
  const std::array<std::string, 6> kRows{"vx", "vy", "vz", "wx", "wy", "wz"};
  for (const Fields& row : every(golden_table(hand_data("fk_jacobian.csv")))) {
    const HandInSpace& hand = hands.at(row.at("id"));
    const auto digit = static_cast<Digit>(
        std::find(kDigitNames.begin(), kDigitNames.end(), row.at("finger")) - kDigitNames.begin());
    const PointJacobian J = point_jacobian(hand, digit, 2, hand.digit(digit).joints[kLinkCount]);
    const auto r = std::find(kRows.begin(), kRows.end(), row.at("row")) - kRows.begin();
    for (std::size_t a = 0; a < 3; ++a) {
      const std::string axis(1, "xyz"[a]);
      EXPECT_WITHIN(J(r, static_cast<Eigen::Index>(a)), number_in(row, "palm_v" + axis), kExact);
      EXPECT_WITHIN(J(r, static_cast<Eigen::Index>(3 + a)), number_in(row, "palm_w" + axis),
                    kExact);
    }
    for (std::size_t d = 0; d < kDigitCount; ++d)
      for (std::size_t a = 0; a < kAngleCount; ++a)
        EXPECT_WITHIN(
            J(r, static_cast<Eigen::Index>(6 + kAngleCount * d + a)),
            number_in(row, std::string(kDigitNames[d]) + "_" + std::string(kDigitAngleNames[a])),
            kExact)
            << row.at("id") << kDigitNames[d] << a;
  }
}

TEST(HandPose, TheJacobianIsTheDerivativeOfThePositionForEveryLinkAndBothHands) {
  constexpr double kStep_rad = 1e-6;
  constexpr double kDifference = 1e-9;  // third derivative of 0.2 m over six, and rounding / step
  Random random(20);
  for (const char* name : {"hand_large", "hand_small_left"}) {
    const HandModel hand = golden_hand(name);
    const HandPose pose = random_hand_pose(random);
    const HandInSpace now = hand_in_space(hand, pose);
    for (std::size_t d = 0; d < kDigitCount; ++d)
      for (std::size_t link = 0; link < kLinkCount; ++link) {
        const PointJacobian J =
            point_jacobian(now, static_cast<Digit>(d), link, now.digits[d].joints[link + 1]);
        for (std::size_t a = 0; a < kAngleCount; ++a) {
          HandPose before = pose;
          HandPose after = pose;
          before.angles[d][a] -= kStep_rad;
          after.angles[d][a] += kStep_rad;
          const Vec3 change = (hand_in_space(hand, after).digits[d].joints[link + 1] -
                               hand_in_space(hand, before).digits[d].joints[link + 1]) /
                              (2.0 * kStep_rad);
          const auto column = static_cast<Eigen::Index>(6 + kAngleCount * d + a);
          EXPECT_WITHIN((J.block<3, 1>(0, column) - change).norm(), 0.0, kDifference)
              << name << kDigitNames[d] << " link " << link << " angle " << a;
        }
      }
  }
}

TEST(HandPose, ALeftHandIsTheReflectionOfTheRightOneInItsPalm) {
  Random random(21);
  for (int k = 0; k < 100; ++k) {
    HandModel hand = golden_hand("hand_default");
    HandPose pose = random_hand_pose(random);
    pose.X_WP = {};
    const auto right = joint_poses(hand_in_space(hand, pose));
    hand.side = Hand::left;
    const auto left = joint_poses(hand_in_space(hand, pose));
    for (std::size_t j = 0; j < kHandJointCount; ++j) {
      const Pose mirror = mirrored(right[j]);
      EXPECT_WITHIN((left[j].p - mirror.p).norm(), 0.0, kExact) << kHandJointNames[j];
      EXPECT_WITHIN(angle_between(left[j].q, mirror.q), 0.0, 10.0 * kExact) << kHandJointNames[j];
    }
  }
}

TEST(HandPose, MovingTheWorldMovesEveryJointAlike) {
  Random random(22);
  const HandModel hand = golden_hand("hand_small_left");
  for (int k = 0; k < 100; ++k) {
    const HandPose pose = random_hand_pose(random);
    const Pose X_VW = random_pose(random);
    const auto in_W = joint_poses(hand_in_space(hand, pose));
    const auto in_V = joint_poses(hand_in_space(hand, {compose(X_VW, pose.X_WP), pose.angles}));
    for (std::size_t j = 0; j < kHandJointCount; ++j)
      EXPECT_WITHIN((in_V[j].p - compose(X_VW, in_W[j]).p).norm(), 0.0, kExact);
  }
}

TEST(HandPose, LinksKeepTheirLengthsAndNothingIsAllocated) {
  Random random(23);
  const HandModel hand = golden_hand("hand_default");
  const HandPose pose = random_hand_pose(random);
  HandInSpace all;
  PointJacobian J;
  std::array<Pose, kHandJointCount> joints;
  const auto before = allocations();
  all = hand_in_space(hand, pose);
  J = point_jacobian(all, Digit::ring, 1, Vec3::Zero());
  joints = joint_poses(all);
  EXPECT_EQ(allocations(), before);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      EXPECT_WITHIN((all.digits[d].joints[k + 1] - all.digits[d].joints[k]).norm(),
                    hand.digits[d].lengths_m[k], kExact);
}

TEST(HandFile, IsReadBackToTheBitAndWhatIsWrongIsNamed) {
  const std::string text = must(read_text(hand_data("hand_small_left.toml")));
  const HandModel hand = must(parse_hand(text, "h.toml"));
  const HandModel again = must(parse_hand(hand_text(hand), "again.toml"));
  EXPECT_EQ(again.side, Hand::left);
  EXPECT_EQ(hand_text(again), hand_text(hand));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    const auto at = other.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return other.replace(at, from.size(), to);
  };
  for (const auto& [bad, message] :
       {std::pair<std::string, std::string>{changed("\"left\"", "\"both\""), "side"},
        {changed("\"index\"", "\"middle\""), "name: 'middle' does not stand here"},
        {changed("hand_length_m = 0.165", "hand_length_m = 165"), "hand_length_m: is out of range"},
        {changed("limits_deg = [[-30, 60], ", "limits_deg = ["), "limits_deg: holds 3 ranges"},
        {changed("limits_deg = [[-30, 60]", "limits_deg = [[60, -30]"), "limits_deg: is no range"},
        {changed("[[finger]]\nname = \"thumb\"", "[[toe]]\nname = \"thumb\""),
         "'index' does not stand here"}}) {
    const auto read = parse_hand(bad, "h.toml");
    ASSERT_FALSE(read) << message;
    EXPECT_NE(read.error().message().find(message), std::string::npos) << read.error().message();
    EXPECT_EQ(read.error().message().find("h.toml"), 0u) << read.error().message();
  }
}

}  // namespace
}  // namespace isograsp::hand_pose_test
