// SPDX-License-Identifier: GPL-3.0-or-later
// m x" + c x' + k x = F turns where x' = 0. With alpha = c / (2 m), D = alpha^2 - k / m,
// w = sqrt(|D|) and slope = (F - k x0) / m - alpha v0:
//   D < 0: tan(w t) = -v0 w / slope
//   D >= 0: tanh(w t) = -v0 w / slope
#include "grasp_model/travel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace isograsp {

namespace {

/// Times after the start, ascending, at which the velocity is zero: at most two. Later ones repeat
/// the first two with smaller travel. A time beyond the hold does not matter here.
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
  // Three events at most: the motion can go from rest at one stop to the other one, but when it
  // comes back it does not reach the first.
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
