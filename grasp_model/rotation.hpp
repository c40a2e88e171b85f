// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes: exponential, logarithm, Jacobians and the geodesic spring. phi is a rotation vector
// [rad]. Formulas: docs/grasp_model.md, "Three rotations".
#pragma once

#include <cmath>

#include "core/spatial.hpp"

namespace isograsp::so3 {

/// Cosine and sine to 1 ulp of 1, without a library call below 1e5 rad: the same bits everywhere.
struct CosSin {
  double cosine = 1.0;
  double sine = 0.0;
};
[[nodiscard]] CosSin cos_sin_any(double x) noexcept;
[[nodiscard, gnu::always_inline]] inline CosSin cos_sin(double x) noexcept {
  constexpr double kReach_rad = 0.7854;
  if (!(std::abs(x) <= kReach_rad)) return cos_sin_any(x);
  // cos x and sin x / x in pairs, polynomials in x^2: interpolated at the Chebyshev points of
  // [0, 0.62], relative error 7e-17 and 4e-18.
  using Pair = Eigen::Array2d;
  const double u = x * x;
  const double u2 = u * u;
  const Pair low = (Pair(1.0, 1.0) + u * Pair(-0.49999999999999227565, -0.16666666666666615116)) +
                   u2 * (Pair(0.041666666666467301687, 0.0083333333333200284316) +
                         u * Pair(-0.001388888886959030172, -0.00019841269828391067657));
  const Pair high = (Pair(2.4801578404008520964e-5, 2.7557313286582730739e-6) +
                     u * Pair(-2.7555212612292537001e-7, -2.5050702774192119067e-8)) +
                    u2 * Pair(2.0629203618557024278e-9, 1.5893901734804999415e-10);
  const Pair both = low + (u2 * u2) * high;
  return {both[0], x * both[1]};
}
/// Unit quaternion of a rotation vector; no angle is too small or too large.
[[nodiscard]] Quat exp(const Vec3& phi) noexcept;
/// Rotation vector of a quaternion (its norm cancels); |phi| in [0, 2 pi], the sign of q is the
/// branch.
[[nodiscard]] Vec3 log(const Quat& q) noexcept;
/// The turn of least angle that takes the direction `from` to that of `to`; of opposite ones, half
/// a turn about some axis across them. @pre neither is zero
[[nodiscard]] Quat shortest(const Vec3& from, const Vec3& to) noexcept;
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
