// SPDX-License-Identifier: GPL-3.0-or-later
// The least force of a pinch: two pads carry a mass that hangs beside their line, each half of its
// weight and half of its torque, with the friction of a disk that slides and turns at once
// (grasp_model/limit_surface.hpp). SI units.
#pragma once

namespace isograsp::virtual_hand {

struct Pinch {
  double mass_kg = 0.0;
  double gravity_m_s2 = 9.81;
  double friction = 0.8;
  double patch_radius_m = 0.005;
  double offset_m = 0.0;  ///< of the centre of mass from the line of the pads
};
struct LeastPinchForce {
  double exact_N = 0.0;      ///< exact Contensou friction, uniform pressure
  double ellipsoid_N = 0.0;  ///< the ellipsoid that stands in for it
};
/// Normal force of each pad.
[[nodiscard]] LeastPinchForce least_pinch_force(const Pinch& pinch) noexcept;

}  // namespace isograsp::virtual_hand
