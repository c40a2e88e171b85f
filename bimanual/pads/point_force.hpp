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

/// Pressure of the bed at the end of the step. Friction is what holds already, `held_N`, and `firm`
/// times the slip, within the disk of `friction` times the pressure: where that is `held_N` again
/// it is Coulomb's, whatever `firm` is. `slip` [m/s]: of the pad over the object.
[[nodiscard]] PointForce force_at(const PadPoint& point, const PointState& state, double friction,
                                  double step_s, const Vec3& slip);

/// Change of the whole force with the slip [N s/m]. Where it slides, the way of the friction is
/// turned as far as `foreseen_N` has come (Chan, Golub, Mulet 1999: Newton then seldom goes too
/// far); at the answer that is the derivative.
[[nodiscard]] Mat3 hardness_at(const PadPoint& point, const PointState& state, double friction,
                               double step_s, const PointForce& force);

}  // namespace isograsp::bimanual
