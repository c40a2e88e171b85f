// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes of segments: sign, mean, rotation vector and angles; poses composed. Unit quaternions
// (w, x, y, z), angles in rad. Real-time: nothing here allocates.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "core/spatial.hpp"
#include "kinematics/largest_eigenvector.hpp"

namespace isograsp {

/// A pose that is not there: NaN in all places, so that it cannot be taken for one.
inline constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
[[nodiscard]] inline Pose missing_pose() noexcept {
  return {Vec3::Constant(kMissing), Quat(kMissing, kMissing, kMissing, kMissing)};
}
[[nodiscard]] inline bool is_missing(const Vec3& p) noexcept {
  return !(p.allFinite());
}
[[nodiscard]] inline bool is_missing(const Quat& q) noexcept {
  return !(q.coeffs().allFinite());
}
[[nodiscard]] inline bool is_missing(const Pose& pose) noexcept {
  return is_missing(pose.p);
}

/// X_AC = X_AB X_BC; a missing one gives a missing one.
[[nodiscard]] inline Pose compose(const Pose& X_AB, const Pose& X_BC) noexcept {
  return {X_AB.p + X_AB.q * X_BC.p, X_AB.q * X_BC.q};
}
/// X_BA of X_AB.
[[nodiscard]] inline Pose inverse(const Pose& X_AB) noexcept {
  const Quat back = X_AB.q.conjugate();
  return {-(back * X_AB.p), back};
}
/// The world reflected, x -> -x: positions S p, attitudes S R S with S = diag(-1, 1, 1).
[[nodiscard]] inline Vec3 mirrored(const Vec3& p) noexcept {
  return {-p.x(), p.y(), p.z()};
}
[[nodiscard]] inline Pose mirrored(const Pose& pose) noexcept {
  return {mirrored(pose.p), Quat(pose.q.w(), pose.q.x(), -pose.q.y(), -pose.q.z())};
}

/// The unit quaternion along these numbers; nothing if they are none (zero or too large). One that
/// is of length 1 up to rounding stays as it is, so that what is written is read back to the same
/// bits.
[[nodiscard]] std::optional<Quat> unit_quaternion(double w, double x, double y, double z) noexcept;
/// Of q and -q, the same attitude, the one whose first component that is not zero is positive.
[[nodiscard]] Quat canonical(const Quat& q) noexcept;
/// The one nearer to `last`, so that the sign is continuous in time; canonical() if that is
/// missing.
[[nodiscard]] Quat continued(const Quat& q, const Quat& last) noexcept;

/// Rotation vector [rad] of length 0 to pi; the sign of q does not count.
[[nodiscard]] Vec3 rotation_vector(const Quat& q) noexcept;

/// Which three turns an attitude is written as: rpy R = Rz(a3) Ry(a2) Rx(a1), roll, pitch, yaw;
/// zxy R = Rz(a1) Rx(a2) Ry(a3).
enum class AngleSequence : std::uint8_t { rpy, zxy };
inline constexpr std::string_view kAngleSequenceNames[] = {"rpy", "zxy"};
/// (a1, a2, a3) [rad]: a2 in [-pi/2, pi/2], the others in [-pi, pi]. Where cos a2 < 1e-9 only the
/// sum or difference of the others is known: the angle of the innermost turn (rpy a1, zxy a3) is 0.
[[nodiscard]] Vec3 angles_of(const Quat& q, AngleSequence sequence) noexcept;
/// The attitude with these angles, whatever they are: angles_of() gives them back where they are in
/// its ranges.
[[nodiscard]] Quat attitude_of(const Vec3& angles_rad, AngleSequence sequence) noexcept;

/// Mean attitude: the unit quaternion m that maximises sum (m . q_k)^2; the signs of the q_k do not
/// count.
class MeanAttitude {
 public:
  void add(const Quat& q) noexcept {
    const Vec4 c(q.w(), q.x(), q.y(), q.z());
    sum_ += c * c.transpose();
  }
  /// canonical(). @pre something was added
  [[nodiscard]] Quat mean() const noexcept;

 private:
  Mat4 sum_ = Mat4::Zero();
};

}  // namespace isograsp
