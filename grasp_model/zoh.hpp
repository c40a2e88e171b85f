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

/// Position and velocity of one degree of freedom.
struct Motion {
  double x = 0.0;
  double v = 0.0;
};

/// Coefficients of the step over one hold. Exact but for rounding, for any h >= 0: c = 0, k = 0,
/// critical damping, stiff and overdamped alike. Real-time safe.
class LinearStep {
 public:
  LinearStep() = default;
  LinearStep(const Oscillator& oscillator, double hold_s) noexcept;

  /// State after the hold. For m = 0 the velocity is what force and spring leave for the damper.
  [[nodiscard]] Motion advance(const Motion& start, double force) const noexcept;

  /// Response at the end of the hold to a unit impulse at its start: position, velocity.
  [[nodiscard]] Motion impulse() const noexcept;

  // Response to unit start velocity S, its integral P and its derivative Q; to unit start position
  // R = 1 - (k/m) P. For m = 0: R and P = integral of R / c are used, S = Q = 0.
  [[nodiscard]] double S() const noexcept { return S_; }
  [[nodiscard]] double P() const noexcept { return P_; }
  [[nodiscard]] double Q() const noexcept { return Q_; }
  [[nodiscard]] double R() const noexcept { return R_; }

 private:
  Oscillator oscillator_;
  double S_ = 0.0;
  double P_ = 0.0;
  double Q_ = 1.0;
  double R_ = 1.0;
  bool about_rest_ = false;  ///< step the distance to F/k instead of the position
};

/// Bounds of the travel.
struct Travel {
  double least = 0.0;
  double most = 0.0;
};

/// The same step with stops: inside the hold the motion is followed to the crossing, stops there
/// (no bounce) and rests or leaves as the force says. Real-time safe; costs as `step` unless a stop
/// or a turning point lies within the hold.
[[nodiscard]] Motion advance_within(const Oscillator& oscillator, const LinearStep& step,
                                    const Travel& travel, double hold_s, Motion start,
                                    double force) noexcept;

}  // namespace isograsp
