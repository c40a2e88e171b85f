// SPDX-License-Identifier: GPL-3.0-or-later
// The exact step of one degree of freedom, m x" + c x' + k x = F with F constant over the hold.
// Formulas and their safe numerical form: docs/grasp_model.md, "Exact step". SI units; for a
// rotation read inertia, angle and torque.
#pragma once

namespace isograsp {

/// Constants of one degree of freedom; none is negative, and m and c are not both 0.
struct Oscillator {
  double m = 0.0;  ///< [kg] or [kg m^2]; 0: first order, c x' + k x = F
  double c = 0.0;  ///< [N s/m] or [N m s/rad]
  double k = 0.0;  ///< [N/m] or [N m/rad]
};

/// c^2 - 4 m k without cancellation (Kahan): exact to about one rounding.
[[nodiscard]] double discriminant(const Oscillator& oscillator) noexcept;

/// Position and velocity of one degree of freedom.
struct Motion {
  double x = 0.0;
  double v = 0.0;
};

/// What the hold makes of the start: response to unit start velocity S, its integral P and its
/// derivative Q; to unit start position R = 1 - (k/m) P. For m = 0: S = Q = 0, and P is the
/// response to a unit force (integral of R / c).
struct Response {
  double S = 0.0;
  double P = 0.0;
  double Q = 1.0;
  double R = 1.0;
};

/// Exact but for rounding, for any h >= 0: c = 0, k = 0, critical damping, stiff and overdamped
/// alike. Real-time safe.
[[nodiscard]] Response response(const Oscillator& oscillator, double hold_s) noexcept;

/// Motion at the end of the hold after a unit impulse at its start. Real-time safe.
[[nodiscard]] Motion impulse_response(const Oscillator& oscillator, double hold_s) noexcept;

/// The step with all that is constant computed once: no division, no branch. Real-time safe.
struct LinearStep {
  LinearStep() = default;  ///< of a locked axis: nothing moves
  LinearStep(const Oscillator& oscillator, double hold_s) noexcept;

  /// State after the hold. For m = 0 the velocity is that at which the damper balances force and
  /// spring.
  [[nodiscard]] Motion advance(const Motion& start, double force) const noexcept {
    const double pushed = force_share * force;
    const double off = pushed - position_share * start.x;
    const double base = about_rest ? pushed : start.x;
    return {base + (x_of_v * start.v + x_of_off * off), v_of_v * start.v + v_of_off * off};
  }

  // True if most of the way to the rest F/k is covered in one hold: then `off` is the distance F/k
  // - x to the rest, and the step begins there. False: `off` is the force F - k x, and the step
  // begins at x.
  bool about_rest = false;
  double force_share = 1.0;     ///< 1/k, or 1
  double position_share = 0.0;  ///< 1, or k
  double x_of_v = 0.0;
  double x_of_off = 0.0;
  double v_of_v = 1.0;
  double v_of_off = 0.0;
};

}  // namespace isograsp
