// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation vector of a quaternion on the way that every step takes: no transcendental function
// up to half a turn. Inside grasp_model/ only.
#pragma once

#include <array>
#include <cmath>

namespace isograsp::so3 {

/// atan(sqrt(u)) / sqrt(u) on 0 <= u <= tan^2(22.5 deg): interpolated at the Chebyshev points of
/// [0, 0.18], relative error 2e-18.
inline constexpr std::array<double, 12> kAtan{
    0.99999999999999999785,   -0.33333333333332988423,  0.19999999999908397494,
    -0.14285714276163336721,  0.11111110595175503333,   -0.090908925875751227634,
    0.076919713876241141661,  -0.066621225134109813804, 0.058409193896630637071,
    -0.050085783940660889834, 0.03729948684921499417,   -0.017085141492542090346};
inline constexpr double kAtanReach = 0.17157287525380990;  // tan^2(22.5 deg)

/// `T`: a number, or several side by side.
template <class T>
[[nodiscard, gnu::always_inline]] inline T atan_ratio(const T& u) noexcept {
  const auto& a = kAtan;
  const T u2 = u * u;
  const T u4 = u2 * u2;
  const T low = (a[0] + a[1] * u) + u2 * (a[2] + a[3] * u);
  const T middle = (a[4] + a[5] * u) + u2 * (a[6] + a[7] * u);
  const T high = (a[8] + a[9] * u) + u2 * (a[10] + a[11] * u);
  return low + u4 * (middle + u4 * high);
}

/// phi / v for q = (w, v), |v|^2 = s2: no transcendental function up to 90 degrees.
[[nodiscard, gnu::always_inline]] inline double angle_ratio(double s2, double w) noexcept {
  if (w > 0.0) {
    if (s2 <= kAtanReach * (w * w)) {
      const double inverse = 1.0 / w;
      return 2.0 * inverse * atan_ratio(s2 * inverse * inverse);
    }
    const double inverse = 1.0 / (w + std::sqrt(s2 + w * w));  // of the half angle
    const double u = s2 * inverse * inverse;
    if (u <= kAtanReach) return 4.0 * inverse * atan_ratio(u);
  }
  const double s = std::sqrt(s2);
  return s == 0.0 ? 2.0 / w : 2.0 * std::atan2(s, w) / s;
}

}  // namespace isograsp::so3
