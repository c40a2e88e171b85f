// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: what one point of a pad gives at a slip, in closed form.
#pragma once

#include "bimanual/pads/pad_step.hpp"

namespace isograsp::bimanual {

/// What a point has besides its place.
struct PointState {
  double stiffness_N_m = 0.0;  ///< of its piece of the bed
  double at_rest_m = 0.0;      ///< penetration at the end of the step if nothing slipped
  double firm = 0.0;           ///< [N s/m]
  double hardest = 0.0;        ///< that `firm` may become
  Vec3 held_N = Vec3::Zero();
  Vec3 foreseen_N = Vec3::Zero();  ///< friction, by the Newton step before
};

/// On the object. `slides`: friction is all that the pressure allows.
struct PointForce {
  double normal_N = 0.0;
  double limit_N = 0.0;
  bool slides = false;
  Vec3 asked_N = Vec3::Zero();
  Vec3 friction_N = Vec3::Zero();
};

/// How the pad moves over the object at a point [m/s].
struct PointSlip {
  double closing = 0.0;        ///< along the point's normal
  Vec3 across = Vec3::Zero();  ///< where and in the plane in which it rubs
};

/// Pressure of the bed at the end of the step. Friction is what holds already, `held_N`, and `firm`
/// times the slip, within the disk of `friction` times the pressure: where that is `held_N` again
/// it is Coulomb's, whatever `firm` is.
[[nodiscard]] PointForce force_at(const PointState& state, double friction, double step_s,
                                  const PointSlip& slip);

/// Change of the friction with the slip across `normal` [N s/m], the pressure held. Where it
/// slides, the way of the friction is turned as far as `foreseen_N` has come (Chan, Golub, Mulet
/// 1999: Newton then seldom goes too far); at the answer that is the derivative.
[[nodiscard]] Mat3 friction_hardness(const Vec3& normal, const PointState& state,
                                     const PointForce& force);
/// By how much friction grows with the pressure: nothing where it sticks.
[[nodiscard]] Vec3 friction_of_pressure(double friction, const PointForce& force);

}  // namespace isograsp::bimanual
