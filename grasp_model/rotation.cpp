// SPDX-License-Identifier: GPL-3.0-or-later
// A turn by t = |phi| about phi; quotients that lose digits near t = 0 are series there:
//   exp(phi) = (cos(t/2), sin(t/2) phi / t),  log(w, v) = 2 atan2(|v|, w) v / |v|
//   shortest turn of a to b, |a| = |b| = 1: (|a + b|, |a - b| along a x b) / 2
//   Jr(phi) u = u - a phi x u + b phi x (phi x u),  a = (1 - cos t) / t^2,  b = (t - sin t) / t^3
//   Jr^-1(phi) u = u + phi x u / 2 + d phi x (phi x u),  d = (1 - (t/2) cot(t/2)) / t^2
//   Jr^-T(phi) u = u - phi x u / 2 + d phi x (phi x u)
//   torque of a spring with stiffness k about each axis = -Jr^-T(phi) diag(k) phi
#include "grasp_model/rotation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp::so3 {

namespace {

double length(const Vec3& v) noexcept {
  const double square = v.squaredNorm();
  return square > 1e-280 && square < 1e280 ? std::sqrt(square) : v.stableNorm();
}

/// (1 - (t/2) cot(t/2)) / t^2, even in t, pole at 2 pi.
double cotangent_term(double t) noexcept {
  constexpr double kSeries_rad = 0.05;
  const double t2 = t * t;
  if (t < kSeries_rad) return 1.0 / 12.0 + t2 * (1.0 / 720.0 + t2 / 30240.0);
  return (1.0 - 0.5 * t / std::tan(0.5 * t)) / t2;
}

}  // namespace

CosSin cos_sin(double x) noexcept {
  const auto near = [](double y) {
    const auto half = half_turn(2.0 * y);
    return CosSin{half[0], (2.0 * y) * half[1]};
  };
  if (std::abs(x) <= 0.5 * kNear_rad) return near(x);
  constexpr double kReach_rad = 1e5;
  if (!(std::abs(x) <= kReach_rad)) return {std::cos(x), std::sin(x)};
  // Quarter turns taken off with pi / 2 in two parts: the first has 33 bits, so that its multiples
  // are exact (Cody and Waite).
  constexpr double kHalfPiHigh = 0x1.921fb544p+0;
  constexpr double kHalfPiLow = 0x1.0b4611a626331p-34;
  const double turns = std::nearbyint(x * (2.0 / std::numbers::pi));
  const CosSin rest = near((x - turns * kHalfPiHigh) - turns * kHalfPiLow);
  switch (static_cast<int>(turns) & 3) {
    case 0: return rest;
    case 1: return {-rest.sine, rest.cosine};
    case 2: return {-rest.cosine, -rest.sine};
    default: return {rest.sine, -rest.cosine};
  }
}

Quat exp(const Vec3& phi) noexcept {
  const double half = 0.5 * length(phi);
  const double scale = half == 0.0 ? 0.5 : 0.5 * std::sin(half) / half;
  return {std::cos(half), scale * phi.x(), scale * phi.y(), scale * phi.z()};
}

Vec3 log(const Quat& q) noexcept {
  const double v = length(q.vec());
  if (v == 0.0) return 2.0 / q.w() * q.vec();
  return 2.0 * std::atan2(v, q.w()) / v * q.vec();
}

Quat shortest(const Vec3& from, const Vec3& to) noexcept {
  const Vec3 a = from.stableNormalized(), b = to.stableNormalized();
  const Vec3 sum = a + b;
  // a x sum is a x b, and keeps its digits where they are opposite.
  const Vec3 across = a.cross(sum);
  const double cosine = 0.5 * length(sum), sine = 0.5 * length(a - b);
  const double size = length(across);
  Vec3 axis = Vec3::Zero();
  if (size > 0.0)
    axis = across / size;
  else if (cosine < 0.5)
    axis = a.unitOrthogonal();
  return {cosine, sine * axis.x(), sine * axis.y(), sine * axis.z()};
}

Vec3 jr(const Vec3& phi, const Vec3& u) noexcept {
  constexpr double kSeries_rad = 0.05;
  const double t2 = phi.squaredNorm();
  const double t = std::sqrt(t2);
  double a = 0.5 - t2 * (1.0 / 24.0 - t2 / 720.0);          // (1 - cos t) / t^2
  double b = 1.0 / 6.0 - t2 * (1.0 / 120.0 - t2 / 5040.0);  // (t - sin t) / t^3
  if (t >= kSeries_rad) {
    const double half = std::sin(0.5 * t);
    a = 2.0 * half * half / t2;
    b = (t - std::sin(t)) / (t2 * t);
  }
  const Vec3 cross = phi.cross(u);
  return u - a * cross + b * phi.cross(cross);
}

Vec3 jr_inverse(const Vec3& phi, const Vec3& u) noexcept {
  const Vec3 cross = phi.cross(u);
  return u + 0.5 * cross + cotangent_term(phi.norm()) * phi.cross(cross);
}

Vec3 jr_inverse_transpose(const Vec3& phi, const Vec3& u) noexcept {
  const Vec3 cross = phi.cross(u);
  return u - 0.5 * cross + cotangent_term(phi.norm()) * phi.cross(cross);
}

Vec3 spring_torque(const Vec3& phi, const Vec3& k) noexcept {
  if (k.x() == k.y() && k.y() == k.z()) return -k.x() * phi;  // phi is an eigenvector of Jr
  const Vec3 linear = k.cwiseProduct(phi);
  const Vec3 cross = phi.cross(linear);
  const double d = cotangent_term(std::min(phi.norm(), kSpringReach_rad));
  return -(linear - 0.5 * cross + d * phi.cross(cross));
}

}  // namespace isograsp::so3
