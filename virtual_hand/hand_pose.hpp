// SPDX-License-Identifier: GPL-3.0-or-later
// Where every part of a hand is: forward kinematics and the Jacobian of a point on it (mathematics
// and signs: docs/virtual_hand.md). World W; pure, without allocation: real-time safe.
#pragma once

#include <Eigen/Core>

#include "virtual_hand/hand_model.hpp"

namespace isograsp::virtual_hand {

/// Degrees of freedom: velocity of the palm's origin, angular velocity of the palm (world axes),
/// then the rates of four angles of each digit.
inline constexpr std::size_t kHandDofs = 6 + kDigitCount * kAngleCount;

struct HandPose {
  Pose X_WP;  ///< of the palm
  std::array<DigitAngles, kDigitCount> angles{};
};

/// One digit in the world.
struct DigitPose {
  std::array<Vec3, kLinkCount + 1> joints;  ///< ends of its links, the tip last [m]
  std::array<Quat, kLinkCount> links;       ///< attitude: -z to the tip
  /// Axes of abduction and of the three flexions, unit vectors; their rates are about these.
  std::array<Vec3, kAngleCount> axes;
};

struct HandInSpace {
  Pose X_WP;
  std::array<Vec3, kDigitCount> metacarpals;  ///< where they begin
  std::array<DigitPose, kDigitCount> digits;

  [[nodiscard]] const DigitPose& digit(Digit which) const noexcept {
    return digits[index_of(which)];
  }
};

/// Every joint and link of the hand. Angles are taken as they are, within limits or not.
[[nodiscard]] HandInSpace hand_in_space(const HandModel& hand, const HandPose& pose) noexcept;

/// Rows: velocity of the point, angular velocity of its link (world axes); columns: kHandDofs.
using PointJacobian = Eigen::Matrix<double, 6, static_cast<int>(kHandDofs)>;
/// Of a point that moves with link 0, 1 or 2 of a digit and is at `p_W` now.
[[nodiscard]] PointJacobian point_jacobian(const HandInSpace& hand, Digit digit, std::size_t link,
                                           const Vec3& p_W) noexcept;

/// Poses of all joints: the attitude is that of the bone that begins there, at a tip that of the
/// last one; wrist, palm and the four metacarpals have that of the palm.
[[nodiscard]] std::array<Pose, kHandJointCount> joint_poses(const HandInSpace& hand) noexcept;

}  // namespace isograsp::virtual_hand
