// SPDX-License-Identifier: GPL-3.0-or-later
// A patch of points pressed on a bed of springs: how the pressure is spread, and the friction of
// all points together while the patch slides and turns (Talvas et al., aggregate constraints;
// docs/grasp_model.md, "Contact patch"). Per newton of normal force; tangent plane of the contact.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "grasp_model/patch/contact_patch.hpp"

namespace isograsp {

struct PatchPoint {
  Vec2 p_m = Vec2::Zero();
  double area_m2 = 0.0;
  double penetration_m = 0.0;  ///< 0 or less: it does not touch
};

/// The patch slides with v at its centroid and turns with w about the normal.
struct SlipTwist {
  Vec2 v_mps = Vec2::Zero();
  double w_radps = 0.0;
};
struct SlipFriction {
  Vec2 force = Vec2::Zero();  ///< on the patch, per newton of normal force
  double torque_m = 0.0;      ///< about the centroid, per newton
  double dissipation = 0.0;   ///< power per newton [m/s]
};

struct PressedPatch {
  /// Pressure of each point over the mean of those that touch, all areas alike.
  std::vector<double> weights;
  std::vector<PressedPoint> touching;
  Vec2 centroid_m = Vec2::Zero();  ///< of the pressure
  double torsion_m = 0.0;          ///< torsional limit about it, per newton
  double pure_torsion_limit_m = 0.0;
  double volume_m3 = 0.0;  ///< that the points have gone in
};

/// Pressure grows with the penetration. Errors: no point touches, or one has no area.
[[nodiscard]] Result<PressedPatch> press(std::span<const PatchPoint> points, double friction);

/// Coulomb's friction of each point against its own slip; a point that does not slip gives none.
[[nodiscard]] SlipFriction friction_of(const PressedPatch& patch, double friction,
                                       const SlipTwist& slip) noexcept;

}  // namespace isograsp
