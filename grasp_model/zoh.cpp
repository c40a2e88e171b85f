// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/zoh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace isograsp {

namespace {

/// (e^z - 1) / z.
double phi1(double z) noexcept {
  return z == 0.0 ? 1.0 : std::expm1(z) / z;
}

/// c^2 - 4 m k without cancellation (Kahan): exact to about one rounding.
double discriminant(const Oscillator& o) noexcept {
  const double product = 4.0 * o.m * o.k;
  const double error = std::fma(-4.0 * o.m, o.k, product);
  return std::fma(o.c, o.c, -product) + error;
}

}  // namespace

LinearStep::LinearStep(const Oscillator& oscillator, double hold_s) noexcept
    : oscillator_(oscillator) {
  const auto [m, c, k] = oscillator;
  const double h = hold_s;
  if (m == 0.0) {
    const double z = -k * h / c;
    R_ = std::exp(z);
    P_ = h / c * phi1(z);
    S_ = 0.0;
    Q_ = 0.0;
    about_rest_ = -z > 0.5;
    return;
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
  S_ = h * s;
  P_ = h * h * p;
  Q_ = q;
  R_ = r;
  about_rest_ = b2 * p > 0.5;
}

Motion LinearStep::advance(const Motion& start, double force) const noexcept {
  const auto [m, c, k] = oscillator_;
  if (m == 0.0) {
    const double rate = (force - k * start.x) / c;
    if (about_rest_) {
      const double rest = force / k;
      return {rest + (start.x - rest) * R_, rate * R_};
    }
    return {start.x + (force - k * start.x) * P_, rate * R_};
  }
  if (about_rest_) {
    const double rest = force / k;
    const double y = start.x - rest;
    return {rest + y * R_ + start.v * S_, start.v * Q_ - y * (k / m) * S_};
  }
  const double acceleration = (force - k * start.x) / m;
  return {start.x + start.v * S_ + acceleration * P_, start.v * Q_ + acceleration * S_};
}

Motion LinearStep::impulse() const noexcept {
  if (oscillator_.m == 0.0)
    return {R_ / oscillator_.c, -oscillator_.k * R_ / (oscillator_.c * oscillator_.c)};
  return {S_ / oscillator_.m, Q_ / oscillator_.m};
}

namespace {

/// Times after the start, ascending, at which the velocity is zero: at most two. Later ones repeat
/// the first two with smaller travel. A time beyond the hold is no matter of ours.
std::array<double, 2> turning_times(const Oscillator& o, const Motion& start,
                                    double force) noexcept {
  constexpr double kNever = HUGE_VAL;
  if (o.m == 0.0) return {kNever, kNever};
  const double alpha = o.c / (2.0 * o.m);
  const double slope = (force - o.k * start.x) / o.m - alpha * start.v;
  const double D = discriminant(o) / (4.0 * o.m * o.m);
  if (D < 0.0) {
    const double w = std::sqrt(-D);
    double angle = std::atan2(-start.v * w, slope);
    if (angle <= 0.0) angle += std::numbers::pi;
    return {angle / w, (angle + std::numbers::pi) / w};
  }
  const double w = std::sqrt(D);
  const double ratio = slope == 0.0 ? -HUGE_VAL : -start.v / slope;  // tanh(w t) / w
  if (!(ratio > 0.0) || ratio * w >= 1.0) return {kNever, kNever};
  return {w == 0.0 ? ratio : std::atanh(ratio * w) / w, kNever};
}

}  // namespace

Motion advance_within(const Oscillator& oscillator, const LinearStep& step, const Travel& travel,
                      double hold_s, Motion start, double force) noexcept {
  const auto outside = [&travel](double x) { return x < travel.least || x > travel.most; };
  double left_s = hold_s;
  LinearStep whole = step;
  // From rest at a stop the motion can reach the other one, and from there come back no further:
  // three events at most.
  for (int event = 0; event < 4; ++event) {
    const double resting = force - oscillator.k * start.x;
    const bool at_most =
        start.x >= travel.most && (start.v > 0.0 || (start.v == 0.0 && resting >= 0.0));
    const bool at_least =
        start.x <= travel.least && (start.v < 0.0 || (start.v == 0.0 && resting <= 0.0));
    if ((at_most && resting >= 0.0) || (at_least && resting <= 0.0) ||
        (oscillator.m == 0.0 && ((start.x >= travel.most && resting >= 0.0) ||
                                 (start.x <= travel.least && resting <= 0.0))))
      return {start.x, 0.0};
    if (at_most || at_least) start.v = 0.0;

    // The motion is monotone between its turning points: only they and the end can be outside.
    const auto turning_s = turning_times(oscillator, start, force);
    double inside_s = 0.0;
    double outside_s = -1.0;
    for (const double t : {turning_s[0], turning_s[1], left_s}) {
      if (t > left_s) continue;
      const bool end = t == left_s;
      const Motion there =
          end ? whole.advance(start, force) : LinearStep(oscillator, t).advance(start, force);
      if (outside(there.x)) {
        outside_s = t;
        break;
      }
      if (end) return there;
      inside_s = t;
    }
    const bool beyond_most =
        LinearStep(oscillator, outside_s).advance(start, force).x > travel.most;
    for (int halving = 0; halving < 80; ++halving) {
      const double middle_s = 0.5 * (inside_s + outside_s);
      if (middle_s <= inside_s || middle_s >= outside_s) break;
      const double x = LinearStep(oscillator, middle_s).advance(start, force).x;
      (outside(x) ? outside_s : inside_s) = middle_s;
    }
    start = {beyond_most ? travel.most : travel.least, 0.0};
    left_s -= outside_s;
    whole = LinearStep(oscillator, left_s);
  }
  return start;
}

}  // namespace isograsp
