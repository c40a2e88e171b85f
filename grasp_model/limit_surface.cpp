// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/limit_surface.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace isograsp {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Integral of (a cos^2 + b sin^2) / sqrt(cos^2 + kc^2 sin^2) over a quarter turn, kc > 0
/// (Bulirsch's cel with p = 1): a B(m) + b D(m) of m = 1 - kc^2 in one sum, without a difference
/// for a, b >= 0.
double cel(double kc, double a, double b) noexcept {
  constexpr double kConverged = 1e-8;  // quadratic: the next pair agrees to the last digit
  double e = kc;
  double mean = 1.0;
  double p = 1.0;
  while (true) {
    const double before = a;
    const double g = e / p;
    a += b / p;
    b = 2.0 * (b + before * g);
    p += g;
    const double last = mean;
    mean += kc;
    if (std::abs(last - kc) <= kConverged * last) break;
    kc = 2.0 * std::sqrt(e);
    e = kc * mean;
  }
  return 0.5 * kPi * (b + a * mean) / (mean * (mean + p));
}

/// s >= 2. The mean distance of the disk's points from the centre of turning is the sum of
/// c_n s^(1 - 2n), c_0 = 1, c_(n+1) / c_n = (n - 1/2)^2 / ((n + 1) (n + second)); the closed forms
/// would lose s^2 to s^4 digits.
DiskFriction series(double s, double second) noexcept {
  DiskFriction result{1.0, 0.0};
  double term = s;  // c_n s^(1 - 2n)
  double n = 0.0;
  do {
    term = term / s / s * (n - 0.5) * (n - 0.5) / ((n + 1.0) * (n + second));
    n += 1.0;
    result.force -= (2.0 * n - 1.0) * term / s;
    result.torque += 2.0 * n * term;
  } while (4.0 * n * term > kEpsilon * result.torque);
  return result;
}

DiskFriction uniform(double s) noexcept {
  if (s == 1.0) return {8.0 / (3.0 * kPi), 8.0 / (9.0 * kPi)};
  if (s >= 2.0) return series(s, 2.0);
  const double k = s < 1.0 ? s : 1.0 / s;
  const double m = k * k;
  const double kc2 = s < 1.0 ? (1.0 - s) * (1.0 + s) : (s - 1.0) * (s + 1.0) * m;
  const double kc = std::sqrt(kc2);
  const double force = 4.0 / (3.0 * kPi) * cel(kc, 2.0, kc2);
  constexpr double kTorque = 4.0 / (9.0 * kPi);
  if (s < 1.0) return {s * force, kTorque * cel(kc, 3.0 - m, kc2 * (3.0 - 2.0 * m))};
  return {force, kTorque * k * cel(kc, 2.0 - kc2 / m, kc2 / m)};
}

DiskFriction hertz(double s) noexcept {
  if (s >= 2.0) return series(s, 2.5);
  const double s2 = s * s;
  const double f = s * (2.0 - 0.5 * s2);
  const double t = 1.0 - s2 * (1.0 - 0.375 * s2);
  if (s <= 1.0) return {3.0 * kPi / 16.0 * f, 3.0 * kPi / 16.0 * t};
  const double w = std::sqrt((s - 1.0) * (s + 1.0));
  const double angle = std::atan2(1.0, w);
  return {0.375 * (f * angle + w * (0.5 * s2 + 1.0) / s),
          0.375 * (t * angle + w * 0.375 * (2.0 - s2))};
}

}  // namespace

DiskFriction disk_friction(Pressure pressure, double slip) noexcept {
  assert(slip >= 0.0);
  if (std::isinf(slip)) return {1.0, 0.0};
  return pressure == Pressure::uniform ? uniform(slip) : hertz(slip);
}

double disk_torsion_m(Pressure pressure, double friction, double radius_m) noexcept {
  return (pressure == Pressure::uniform ? 2.0 / 3.0 : 3.0 * kPi / 16.0) * friction * radius_m;
}

}  // namespace isograsp
