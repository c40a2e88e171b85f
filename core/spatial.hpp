// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors, rotations, poses and wrenches. SI units; a wrench is (force, torque).
// Frames: W world, O object (origin at its centre of mass), C contact of a finger. Monogram
// notation: p_WO is the position of O measured from W, R_WO turns O components into W components,
// F_O_W is a wrench on O about its centre of mass, expressed in W (docs/conventions.md).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace isograsp {

using Vec3 = Eigen::Vector3d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// Force [N] and torque [N m] about the origin of the frame that the name of the variable says.
struct Wrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

/// Position [m] and attitude (unit quaternion) of one frame in another; which ones, the name of the
/// variable says: X_WO.p is p_WO, X_WO.q is q_WO.
struct Pose {
  Vec3 p = Vec3::Zero();
  Quat q = Quat::Identity();
};

/// Matrix of the cross product: skew(a) b = a x b.
[[nodiscard]] inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Geodesic angle [rad, 0 .. pi] between two attitudes. Exact also for tiny angles (atan2, not
/// acos).
[[nodiscard]] inline double angle_between(const Quat& a, const Quat& b) {
  const Quat d = a.conjugate() * b;
  return 2.0 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

}  // namespace isograsp
