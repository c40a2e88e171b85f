// SPDX-License-Identifier: GPL-3.0-or-later
// What a measured finger force does at its contact: hysteresis, friction clamp. Contact frame: z
// into the object, pressing is +z. SI units. Formulas: docs/grasp_model.md, "Contacts".
#pragma once

#include "core/spatial.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp {

/// On when f_z > threshold, off when f_z <= threshold / 2. Real-time safe.
[[nodiscard]] bool in_contact(bool was, double fz_N, double threshold_N) noexcept;

/// What a contact transmits of a measured wrench.
struct Transmitted {
  Wrench F_C;                ///< at the contact point, contact axes
  double utilisation = 0.0;  ///< share of the friction limit that was asked for; > 1: clamped
  [[nodiscard]] bool slip() const noexcept { return utilisation > 1.0; }
};

/// Radial clamp of the tangential force to mu f_z at the measured f_z (never a projection that
/// would invent grip); soft: of (f_t, t_z) to the ellipsoid. Frictionless: f_z alone. Zero for f_z
/// <= 0. Infinite utilisation: a limit of zero is loaded. Real-time safe.
[[nodiscard]] Transmitted transmit(const Contact& contact, const Wrench& F_C) noexcept;

}  // namespace isograsp
