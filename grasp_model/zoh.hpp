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

/// The step with all that is constant computed once: seven multiplications, no division. Real-time
/// safe.
class LinearStep {
 public:
  LinearStep() = default;  ///< of a locked axis: nothing moves
  LinearStep(const Oscillator& oscillator, double hold_s) noexcept;

  /// State after the hold. For m = 0 the velocity is what force and spring leave for the damper.
  [[nodiscard]] Motion advance(const Motion& start, double force) const noexcept {
    if (about_rest_) {
      const double rest = force * compliance_;
      const double y = start.x - rest;
      return {rest + (y * R_ + start.v * S_), start.v * Q_ - y * pull_};
    }
    const double excess = force - k_ * start.x;
    return {start.x + (start.v * S_ + excess * P_per_m_), start.v * Q_ + excess * S_per_m_};
  }

 private:
  double S_ = 0.0;
  double Q_ = 1.0;
  double k_ = 0.0;
  double P_per_m_ = 0.0;
  double S_per_m_ = 0.0;
  double R_ = 1.0;
  double pull_ = 0.0;        ///< (k/m) S
  double compliance_ = 0.0;  ///< 1/k
  bool about_rest_ = false;  ///< step the distance to F/k instead of the position
};

}  // namespace isograsp
