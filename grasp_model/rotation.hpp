// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes: exponential, logarithm, Jacobians and the geodesic spring. phi is a rotation vector
// [rad]. Formulas: docs/grasp_model.md, "Three rotations".
#pragma once

#include <array>
#include <cmath>

#include "core/spatial.hpp"

namespace isograsp::so3 {

/// cos(x / 2) and sin(x / 2) / x for |x| <= kNear_rad, polynomials in x^2: interpolated at the
/// Chebyshev points of [0, 2.48], relative error 7e-17 and 4e-18.
inline constexpr double kNear_rad = 1.5708;
inline constexpr std::array<std::array<double, 7>, 2> kHalfTurn{
    {{1.0, -0.12499999999999807, 0.0026041666666542064, -2.1701388858734845e-05,
      9.688116564065829e-08, -2.690938731669193e-10, 5.036426664686774e-13},
     {0.5, -0.02083333333333327, 0.00026041666666625087, -1.5500992053430521e-06,
      5.38228775128569e-09, -1.2231788463960995e-11, 1.9401735516119383e-14}}};
/// Both from x.
[[nodiscard, gnu::always_inline]] inline Eigen::Array2d half_turn(double x) noexcept {
  using Pair = Eigen::Array2d;
  const double u = x * x;
  const double u2 = u * u;
  const auto c = [](std::size_t i) __attribute__((always_inline)) {
    return Pair(kHalfTurn[0][i], kHalfTurn[1][i]);
  };
  const Pair low = (c(0) + u * c(1)) + u2 * (c(2) + u * c(3));
  const Pair high = (c(4) + u * c(5)) + u2 * c(6);
  return low + (u2 * u2) * high;
}
/// Cosine and sine to 1 ulp of 1, without a library call below 1e5 rad: the same bits everywhere.
struct CosSin {
  double cosine = 1.0;
  double sine = 0.0;
};
[[nodiscard]] CosSin cos_sin(double x) noexcept;
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
