// SPDX-License-Identifier: GPL-3.0-or-later
// Rotation vector of q = (w, v), w >= 0:  phi = 2 atan2(|v|, w) v / |v|
// Angles from R: the middle one by atan2, so that it keeps its digits near +-pi/2. Then the
// outermost turn is taken back, and the innermost angle is computed from what is left: near +-pi/2
// the errors of both then cancel.
//   rpy: a2 = atan2(-R31, |(R11, R21)|),  a3 = atan2(R21, R11)
//        S = Rz(-a3) R,  a1 = atan2(-S23, S22)
//   zxy: a2 = atan2(R32, |(R31, R33)|),  a1 = atan2(-R12, R22)
//        S = Rz(-a1) R,  a3 = atan2(S13, S11)
// Mean attitude: eigenvector of the largest eigenvalue of sum q q^T (Markley et al. 2007).
#include "kinematics/attitude.hpp"

#include <array>
#include <cmath>

namespace isograsp {

namespace {

Quat negated(const Quat& q) noexcept {
  return {-q.w(), -q.x(), -q.y(), -q.z()};
}

}  // namespace

std::optional<Quat> unit_quaternion(double w, double x, double y, double z) noexcept {
  constexpr double kRounding = 1e-15;
  const Quat q(w, x, y, z);
  const double length = q.norm();
  if (std::abs(length - 1.0) < kRounding) return q;
  if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
  return Quat(q.coeffs() / length);
}

Quat canonical(const Quat& q) noexcept {
  for (const double component : {q.w(), q.x(), q.y(), q.z()}) {
    if (component > 0.0) return q;
    if (component < 0.0) return negated(q);
  }
  return q;
}

Quat continued(const Quat& q, const Quat& last) noexcept {
  if (std::isnan(last.w())) return canonical(q);
  return q.dot(last) < 0.0 ? negated(q) : q;
}

Vec3 rotation_vector(const Quat& q) noexcept {
  const double sine = q.vec().norm();
  if (sine == 0.0) return Vec3::Zero();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  return sign * 2.0 * std::atan2(sine, std::abs(q.w())) / sine * q.vec();
}

Vec3 angles_of(const Quat& q, AngleSequence sequence) noexcept {
  constexpr double kLocked = 1e-9;
  const Mat3 R = q.toRotationMatrix();
  if (sequence == AngleSequence::rpy) {
    const double cosine = std::hypot(R(0, 0), R(1, 0));
    const double pitch = std::atan2(-R(2, 0), cosine);
    if (cosine < kLocked) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
    const double yaw = std::atan2(R(1, 0), R(0, 0));
    const Vec3 second = std::cos(yaw) * R.row(1) - std::sin(yaw) * R.row(0);  // of Rz(-yaw) R
    return {std::atan2(-second.z(), second.y()), pitch, yaw};
  }
  const double cosine = std::hypot(R(2, 0), R(2, 2));
  const double middle = std::atan2(R(2, 1), cosine);
  if (cosine < kLocked) return {std::atan2(R(1, 0), R(0, 0)), middle, 0.0};
  const double first = std::atan2(-R(0, 1), R(1, 1));
  const Vec3 row = std::cos(first) * R.row(0) + std::sin(first) * R.row(1);  // of Rz(-first) R
  return {first, middle, std::atan2(row.z(), row.x())};
}

Quat attitude_of(const Vec3& angles_rad, AngleSequence sequence) noexcept {
  const auto about = [](const Vec3& axis, double rad) {
    return Quat(Eigen::AngleAxisd(rad, axis));
  };
  const auto [x, y, z] = std::array{Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())};
  const double a1 = angles_rad[0], a2 = angles_rad[1], a3 = angles_rad[2];
  return sequence == AngleSequence::rpy ? about(z, a3) * about(y, a2) * about(x, a1)
                                        : about(z, a1) * about(x, a2) * about(y, a3);
}

Quat MeanAttitude::mean() const noexcept {
  const Vec4 v = largest_eigenvector(sum_);
  return canonical(Quat(v[0], v[1], v[2], v[3]));
}

}  // namespace isograsp
