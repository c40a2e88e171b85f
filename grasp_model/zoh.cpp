// SPDX-License-Identifier: GPL-3.0-or-later
// m x" + c x' + k x = F, F constant over the hold h. S is the answer to a unit start velocity, P
// its integral, Q its derivative, R = 1 - (k / m) P the answer to a unit start position:
//   x1 = x0 + S v0 + P A,  v1 = Q v0 + S A,  A = (F - k x0) / m.
// With a = c h / (2 m), b2 = k h^2 / m, D = (c^2 - 4 m k) (h / (2 m))^2, s = S / h, p = P / h^2:
//   a + sqrt(b2) <= 1: power series in a and b2
//   D > 0: s = e^-a sinh(sqrt D) / sqrt D
//          r = e^-a cosh(sqrt D) + a s
//          q = e^-a cosh(sqrt D) - a s
//   D <= 0: the same with sin, cos and sqrt(-D)
//   p = (1 - r) / b2
// m = 0 (c x' + k x = F): R = e^(-k h / c), P = (1 - R) / k.
#include "grasp_model/zoh.hpp"

#include <cmath>

namespace isograsp {

namespace {

/// (e^z - 1) / z.
double phi1(double z) noexcept {
  return z == 0.0 ? 1.0 : std::expm1(z) / z;
}

}  // namespace

double discriminant(const Oscillator& o) noexcept {
  const double product = 4.0 * o.m * o.k;
  const double error = std::fma(-4.0 * o.m, o.k, product);
  return std::fma(o.c, o.c, -product) + error;
}

Response response(const Oscillator& oscillator, double hold_s) noexcept {
  const auto [m, c, k] = oscillator;
  const double h = hold_s;
  if (m == 0.0) {
    const double z = -k * h / c;
    return {0.0, h / c * phi1(z), 0.0, std::exp(z)};
  }
  const double a = c * h / (2.0 * m);
  const double b2 = k * h * h / m;
  double s = 0.0;  // S / h
  double p = 0.0;  // P / h^2
  double q = 0.0;
  double r = 0.0;
  if (a + std::sqrt(b2) <= 1.0) {
    // Power series: no regime, exact at c = 0, k = 0 and critical damping.
    double term = 1.0;
    double before = 0.0;
    double factorial = 1.0;  // (n + 1)!
    for (int n = 0; n < 24; ++n) {
      s += term / factorial;
      factorial *= n + 2;
      p += term / factorial;
      const double next = -2.0 * a * term - b2 * before;
      before = term;
      term = next;
    }
    r = 1.0 - b2 * p;
    q = r - 2.0 * a * s;
  } else {
    const double scale = h / (2.0 * m);
    const double D = discriminant(oscillator) * scale * scale;
    if (D > 0.0) {
      const double root = std::sqrt(D);
      const double z2 = -(a + root);
      const double z1 = -b2 / (a + root);
      const double g = 2.0 * root;
      if (g >= 1.0) {
        const double e1 = std::exp(z1);
        const double e2 = std::exp(z2);
        s = e1 * -std::expm1(-g) / g;
        q = (z1 * e1 - z2 * e2) / g;
        r = (z1 * e2 - z2 * e1) / g;
        p = z1 < -0.5 ? (1.0 - r) / b2 : (phi1(z1) - phi1(z2)) / g;
      } else {
        const double e = std::exp(-a);
        s = e * std::sinh(root) / root;
        r = e * std::cosh(root) + a * s;
        q = e * std::cosh(root) - a * s;
        p = (1.0 - r) / b2;
      }
    } else {
      const double root = std::sqrt(-D);
      const double e = std::exp(-a);
      s = root == 0.0 ? e : e * std::sin(root) / root;
      r = e * std::cos(root) + a * s;
      q = e * std::cos(root) - a * s;
      p = (1.0 - r) / b2;
    }
  }
  return {h * s, h * h * p, q, r};
}

Motion impulse_response(const Oscillator& oscillator, double hold_s) noexcept {
  const auto [m, c, k] = oscillator;
  const auto [S, P, Q, R] = response(oscillator, hold_s);
  if (m == 0.0) return {R / c, -k * R / (c * c)};
  return {S / m, Q / m};
}

LinearStep::LinearStep(const Oscillator& oscillator, double hold_s) noexcept {
  const auto [m, c, k] = oscillator;
  const auto [S, P, Q, R] = response(oscillator, hold_s);
  const double x_of_force = m == 0.0 ? P : P / m;
  about_rest = k * x_of_force > 0.5;
  x_of_v = S;
  v_of_v = Q;
  if (about_rest) {
    force_share = 1.0 / k;
    position_share = 1.0;
    x_of_off = -R;
    v_of_off = m == 0.0 ? k * R / c : k / m * S;
  } else {
    position_share = k;
    x_of_off = x_of_force;
    v_of_off = m == 0.0 ? R / c : S / m;
  }
}

}  // namespace isograsp
