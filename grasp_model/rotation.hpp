// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes: exponential, logarithm, Jacobians and the geodesic spring. phi is a rotation vector
// [rad]. Formulas: docs/grasp_model.md, "Three rotations".
#pragma once

#include <cmath>

#include "core/spatial.hpp"

namespace isograsp::so3 {

/// Cosine and sine; below 0.8 rad without a call, to 1 ulp.
struct CosSin {
  double cosine = 1.0;
  double sine = 0.0;
};
[[nodiscard]] inline CosSin cos_sin(double x) noexcept {
  constexpr double kReach_rad = 0.8;  // the first terms left out are below 1e-17
  if (!(std::abs(x) <= kReach_rad)) return {std::cos(x), std::sin(x)};
  // Both series at once, in pairs: cos x and sin x / x in powers of x^2.
  using Pair = Eigen::Array2d;
  const double u = x * x;
  const double u2 = u * u;
  const double u4 = u2 * u2;
  const Pair low = (Pair(1.0, 1.0) + u * Pair(-1.0 / 2, -1.0 / 6)) +
                   u2 * (Pair(1.0 / 24, 1.0 / 120) + u * Pair(-1.0 / 720, -1.0 / 5040));
  const Pair high = (Pair(1.0 / 40320, 1.0 / 362880) + u * Pair(-1.0 / 3628800, -1.0 / 39916800)) +
                    u2 * (Pair(1.0 / 479001600, 1.0 / 6227020800) +
                          u * Pair(-1.0 / 87178291200, -1.0 / 1307674368000)) +
                    u4 * Pair(1.0 / 20922789888000, 1.0 / 355687428096000);
  const Pair both = low + u4 * high;
  return {both[0], x * both[1]};
}
/// Unit quaternion of a rotation vector; no angle is too small or too large.
[[nodiscard]] Quat exp(const Vec3& phi) noexcept;
/// Rotation vector of a quaternion (its norm cancels); |phi| in [0, 2 pi], the sign of q is the
/// branch.
[[nodiscard]] Vec3 log(const Quat& q) noexcept;
/// Right Jacobian times u: exp(phi + d) = exp(phi) exp(Jr(phi) d) to first order in d.
[[nodiscard]] Vec3 jr(const Vec3& phi, const Vec3& u) noexcept;
/// Its inverse and inverse transpose times u; pole at |phi| = 2 pi.
[[nodiscard]] Vec3 jr_inverse(const Vec3& phi, const Vec3& u) noexcept;
[[nodiscard]] Vec3 jr_inverse_transpose(const Vec3& phi, const Vec3& u) noexcept;

/// Body torque [N m] of the spring with energy phi^T diag(k) phi / 2: its gradient
/// -Jr^-T(phi) diag(k) phi. Beyond 1.9 pi the pole at 2 pi is kept away (kSpringReach_rad).
[[nodiscard]] Vec3 spring_torque(const Vec3& phi, const Vec3& stiffness) noexcept;
inline constexpr double kSpringReach_rad = 1.9 * 3.14159265358979323846;

}  // namespace isograsp::so3
