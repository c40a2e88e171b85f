// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/hand_pose.hpp"

#include <algorithm>
#include <cmath>

#include "kinematics/attitude.hpp"

namespace isograsp::virtual_hand {

namespace {

Quat about_x(double angle_rad) noexcept {
  return {std::cos(0.5 * angle_rad), std::sin(0.5 * angle_rad), 0.0, 0.0};
}
Quat about_y(double angle_rad) noexcept {
  return {std::cos(0.5 * angle_rad), 0.0, std::sin(0.5 * angle_rad), 0.0};
}

/// Of a right hand, in P.
DigitPose digit_in_palm(const DigitModel& digit, const DigitAngles& angles) noexcept {
  DigitPose pose;
  Quat q = digit.base_q * about_y(angles[0]);
  pose.axes[0] = digit.base_q * Vec3::UnitY();
  const Vec3 flexion = -(q * Vec3::UnitX());  // turning about it keeps it
  pose.joints[0] = digit.base_m;
  for (std::size_t k = 0; k < kLinkCount; ++k) {
    q = q * about_x(-angles[k + 1]);
    pose.links[k] = q;
    pose.axes[k + 1] = flexion;
    pose.joints[k + 1] = pose.joints[k] + q * Vec3(0.0, 0.0, -digit.lengths_m[k]);
  }
  return pose;
}

Quat mirrored_attitude(const Quat& q) noexcept {
  return mirrored(Pose{Vec3::Zero(), q}).q;
}

/// An axis of turning is a pseudovector: its reflection points the other way.
void reflect(DigitPose& digit) noexcept {
  for (Vec3& p : digit.joints) p = mirrored(p);
  for (Quat& q : digit.links) q = mirrored_attitude(q);
  for (Vec3& axis : digit.axes) axis = -mirrored(axis);
}

}  // namespace

HandInSpace hand_in_space(const HandModel& hand, const HandPose& pose) noexcept {
  HandInSpace all;
  all.X_WP = pose.X_WP;
  const Vec3& p_WP = pose.X_WP.p;
  const Quat& q_WP = pose.X_WP.q;
  const bool left = hand.side == Hand::left;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    DigitPose digit = digit_in_palm(hand.digits[d], pose.angles[d]);
    if (left) reflect(digit);
    for (Vec3& p : digit.joints) p = p_WP + q_WP * p;
    for (Quat& q : digit.links) q = q_WP * q;
    for (Vec3& axis : digit.axes) axis = q_WP * axis;
    all.digits[d] = digit;
    const Vec3& begins = hand.digits[d].metacarpal_m;
    all.metacarpals[d] = p_WP + q_WP * (left ? mirrored(begins) : begins);
  }
  return all;
}

PointJacobian point_jacobian(const HandInSpace& hand, Digit digit, std::size_t link,
                             const Vec3& p_W) noexcept {
  PointJacobian J = PointJacobian::Zero();
  J.topLeftCorner<3, 3>().setIdentity();
  J.block<3, 3>(0, 3) = -skew(p_W - hand.X_WP.p);
  J.block<3, 3>(3, 3).setIdentity();
  const DigitPose& of = hand.digit(digit);
  for (std::size_t a = 0; a <= link + 1; ++a) {
    const auto column = static_cast<Eigen::Index>(6 + index_of(digit) * kAngleCount + a);
    const Vec3& origin = of.joints[a == 0 ? 0 : a - 1];
    J.block<3, 1>(0, column) = of.axes[a].cross(p_W - origin);
    J.block<3, 1>(3, column) = of.axes[a];
  }
  return J;
}

std::array<Pose, kHandJointCount> joint_poses(const HandInSpace& hand) noexcept {
  std::array<Pose, kHandJointCount> joints;
  const Quat& q_WP = hand.X_WP.q;
  for (std::size_t d = 0; d < kDigitCount; ++d) {
    const auto digit = static_cast<Digit>(d);
    const DigitPose& of = hand.digits[d];
    if (digit != Digit::thumb) joints[metacarpal_joint_of(digit)] = {hand.metacarpals[d], q_WP};
    for (std::size_t end = 0; end <= kLinkCount; ++end)
      joints[joint_of(digit, end)] = {of.joints[end], of.links[std::min(end, kLinkCount - 1)]};
  }
  joints[kWristJoint] = hand.X_WP;
  joints[kPalmJoint] = {
      0.5 * (hand.metacarpals[index_of(Digit::middle)] + hand.digit(Digit::middle).joints[0]),
      q_WP};
  return joints;
}

}  // namespace isograsp::virtual_hand
