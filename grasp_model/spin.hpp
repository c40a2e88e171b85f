// SPDX-License-Identifier: GPL-3.0-or-later
// A body that turns freely: I w' = tau - C w - spring(q) - w x I w, q' = q (0, w) / 2, w in body
// axes, torques constant during a hold. The steps that follow it. SI units, rotation vectors [rad].
// Formulas and choice of method: docs/grasp_model.md, "Three rotations".
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/spatial.hpp"

namespace isograsp::so3 {

/// A body on a torsional spring and damper, principal axes. An inertia of 0 on one axis or on all
/// makes that axis first order; its damping is then not 0.
struct Body {
  Vec3 inertia_kg_m2 = Vec3::Zero();
  Vec3 damping = Vec3::Zero();    ///< [N m s/rad]
  Vec3 stiffness = Vec3::Zero();  ///< [N m/rad]
};

/// Torques that are constant during a hold: one in world axes, one in body axes [N m].
struct Torques {
  Vec3 world = Vec3::Zero();
  Vec3 body = Vec3::Zero();
};

/// Attitude and angular velocity in body axes [rad/s]. The branch of the spring is the sign of q.
struct Spin {
  Quat q_WO = Quat::Identity();
  Vec3 w_O = Vec3::Zero();
};

/// The state as the integrators see it: q as w x y z, w_O, and the work of the torques since the
/// beginning of the hold [J] if it is counted, else 0. Off the unit sphere the equations are
/// continued smoothly, so q is normalised at the end of a hold only.
using SpinVector = Eigen::Matrix<double, 8, 1>;

/// The right-hand side of one hold. Real-time safe.
class SpinRate {
 public:
  SpinRate() = default;
  explicit SpinRate(const Body& body) noexcept;
  void load(const Torques& torques) noexcept;
  /// Steps count the work of the torques and look out for a cheaper order.
  void watch() noexcept { watched_ = true; }
  [[nodiscard]] bool spring() const noexcept { return spring_; }
  [[nodiscard]] bool watched() const noexcept { return watched_; }

  /// Sets the velocity of massless axes to that at which their damper balances all other torques.
  void settle(SpinVector& y) const noexcept;
  [[nodiscard]] const Body& body() const noexcept { return body_; }
  [[nodiscard]] const Torques& torques() const noexcept { return torques_; }
  /// Fastest rate of the motion in the hold [1/s]: |w| + sqrt(max k/I) + max c/I, where |w| counts
  /// what the torques can add to it.
  [[nodiscard]] double fastest(const SpinVector& y, double hold_s) const noexcept;
  /// Its parts: the least torque that a speed of 1 rad/s within the hold costs [N m s], and the
  /// rate of spring and damper [1/s].
  [[nodiscard]] double resisting(double hold_s) const noexcept;
  [[nodiscard]] double own_rate() const noexcept { return own_rate_; }
  /// The damper is faster than the spring: motion settles instead of swinging.
  [[nodiscard]] bool overdamped() const noexcept { return overdamped_; }
  /// Part of the motion is too fast for steps of `step_s` and has not died away at the end of the
  /// hold: a step that damps it would look exact and be wrong.
  [[nodiscard]] bool too_fast(const SpinVector& y, double step_s, double hold_s) const noexcept;
  /// Torque of all but damper and gyroscopic term [N m].
  [[nodiscard]] Vec3 drive(const SpinVector& y) const noexcept;
  /// Rate at which the torques that are constant in the hold do work [W].
  [[nodiscard]] double power(const SpinVector& y) const noexcept;
  /// Of the turning body and its spring [J].
  [[nodiscard]] double energy(const SpinVector& y) const noexcept;
  /// Takes from the end of a hold what it has more than `most_J`: from the speed, or, at rest, from
  /// the turn of the spring. @return the angle that this turned the body [rad]
  double limit_energy(double most_J, SpinVector& y) const noexcept;

 private:
  friend class ExplicitRate;
  [[nodiscard]] Vec3 held(const SpinVector& y) const noexcept;
  [[nodiscard]] Vec3 settled(const Vec3& driving, Vec3 w_O) const noexcept;

  Body body_;
  Torques torques_;
  Vec3 inverse_inertia_ = Vec3::Zero();  ///< 0 where massless
  double own_rate_ = 0.0;                ///< of spring and damper [1/s]
  bool massless_ = false;
  bool overdamped_ = false;
  bool spring_ = false;
  bool even_spring_ = false;  ///< the same stiffness on all axes
  bool world_ = false;
  bool watched_ = false;
};

/// A difference of attitudes as the angle it means [rad].
[[nodiscard]] inline double angle_of(const SpinVector& difference) noexcept {
  return 2.0 * difference.head<4>().norm();
}

[[nodiscard]] SpinVector pack(const Spin& spin) noexcept;
[[nodiscard]] Spin unpack(const SpinVector& y) noexcept;

/// Explicit Runge-Kutta steps by their order: what a coarser answer costs less.
enum class Order : std::uint8_t {
  third,   ///< Bogacki-Shampine 3(2), 3 evaluations
  fifth,   ///< Cash-Karp 5(4), 6 evaluations
  eighth,  ///< Dormand-Prince 8(5,3), 12 evaluations
};
/// Of the right-hand side in one step.
[[nodiscard]] int evaluations(Order order) noexcept;
/// A step is stable up to this turn of the fastest rate [rad].
[[nodiscard]] double stable_rad(Order order) noexcept;
/// What one step of this order errs by, about, if the fastest rate turns `turn_rad` in it [rad].
[[nodiscard]] double typical_error_rad(Order order, double turn_rad) noexcept;

/// The true error of an explicit step's attitude is at most this many times the estimate, while the
/// fastest rate turns no more than stable_rad().
[[nodiscard]] double estimate_factor(Order order) noexcept;

/// End of a step and the estimate of its error [rad].
struct SpinStep {
  SpinVector end;
  double error_rad = 0.0;
  /// What the next lower order would have estimated, if the rate is watched and there is one.
  double coarser_rad = std::numeric_limits<double>::infinity();
};

/// States at the stages of an explicit step; those of follow.hpp's stage_nodes() are the nodes of a
/// quadrature of the same order along the motion.
using StageStates = std::array<SpinVector, 12>;

/// One explicit step. `seen`: the states at its stages, if wanted. Real-time safe.
[[nodiscard]] SpinStep explicit_step(Order order, const SpinRate& rate, const SpinVector& start,
                                     double h_s, StageStates* seen) noexcept;
/// The same bits without the wide registers of this processor.
[[nodiscard]] SpinStep explicit_step_narrow(Order order, const SpinRate& rate,
                                            const SpinVector& start, double h_s) noexcept;
/// The state between the ends of a step at `share` of it: the cubic in the Lie algebra that fits
/// both velocities. Real-time safe.
[[nodiscard]] SpinVector between(const SpinVector& start, const SpinVector& end, double h_s,
                                 double share) noexcept;
/// Linearly implicit Euler steps extrapolated to order 6: damped at infinity, for bodies too stiff
/// for the explicit step. Real-time safe.
[[nodiscard]] SpinStep stiff_step(const SpinRate& rate, const SpinVector& start,
                                  double h_s) noexcept;

}  // namespace isograsp::so3
