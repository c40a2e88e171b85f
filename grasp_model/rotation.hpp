// SPDX-License-Identifier: GPL-3.0-or-later
// Attitudes: exponential, logarithm, Jacobians, the geodesic spring and the integrator of three
// free rotations. phi is a rotation vector [rad]. Formulas: docs/grasp_model.md, "Three rotations".
#pragma once

#include "core/spatial.hpp"

namespace isograsp::so3 {

/// Unit quaternion of a rotation vector; no angle is too small or too large.
[[nodiscard]] Quat exp(const Vec3& phi) noexcept;
/// Rotation vector of a quaternion (its norm cancels); |phi| in [0, 2 pi], the sign of q is the
/// branch.
[[nodiscard]] Vec3 log(const Quat& q) noexcept;
/// Right Jacobian times u: exp(phi + d) = exp(phi) exp(Jr(phi) d) to first order in d.
[[nodiscard]] Vec3 jr(const Vec3& phi, const Vec3& u) noexcept;
/// Its inverse and inverse transpose times u; pole at |phi| = 2 pi.
[[nodiscard]] Vec3 jr_inverse(const Vec3& phi, const Vec3& u) noexcept;
[[nodiscard]] Vec3 jr_inverse_transpose(const Vec3& phi, const Vec3& u) noexcept;

/// Body torque [N m] of the spring with energy phi^T diag(k) phi / 2: its gradient
/// -Jr^-T(phi) diag(k) phi. Beyond 1.9 pi the pole at 2 pi is kept away (kSpringReach_rad).
[[nodiscard]] Vec3 spring_torque(const Vec3& phi, const Vec3& stiffness) noexcept;
inline constexpr double kSpringReach_rad = 1.9 * 3.14159265358979323846;

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

/// Fastest rate of the motion in the hold [1/s]: |w| + sqrt(max k/I) + max c/I, where |w| counts
/// what the torques can add to it.
[[nodiscard]] double fastest_rate(const Body& body, const Torques& torques, const Spin& spin,
                                  double hold_s) noexcept;

/// A substep turns the fastest rate by at most this [rad] …
inline constexpr double kSubstep_rad = 0.05;
/// … with at most this many substeps a hold; beyond, the answer is flagged.
inline constexpr int kMostSubsteps = 256;
/// Runge-Kutta stays stable up to this; beyond, a linearly implicit step that cannot diverge.
inline constexpr double kStable_rad = 2.0;

/// How one hold is divided.
struct Division {
  int substeps = 1;
  bool implicit = false;            ///< too stiff for Runge-Kutta
  bool tolerance_exceeded = false;  ///< the cap was reached
};
[[nodiscard]] Division divide(double rate, double hold_s) noexcept;

/// One substep of RKMK4 (Runge-Kutta of order 4 in the Lie algebra). Real-time safe.
void rkmk4(const Body& body, const Torques& torques, double h_s, Spin& spin) noexcept;
/// One linearly implicit (order 1, damped) substep for stiff bodies. Real-time safe.
void implicit_step(const Body& body, const Torques& torques, double h_s, Spin& spin) noexcept;

}  // namespace isograsp::so3
