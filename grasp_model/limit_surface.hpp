// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of a contact patch that slides and turns about its normal at once (Coulomb-Contensou),
// exact for a disk, and its torsional limit (that of any patch: patch/). For contacts with a known
// slip velocity; measured forces use the ellipsoid (contact.hpp). Formulas: docs/grasp_model.md,
// "Soft finger". SI units.
#pragma once

#include <cstdint>

namespace isograsp {

/// How a disk presses: everywhere alike, or as elastic bodies do (greatest in the middle).
enum class Pressure : std::uint8_t { uniform, hertz };

/// Friction as a share: force / (mu N), torque / (mu N R), N the normal force, R the radius.
struct DiskFriction {
  double force = 0.0;
  double torque = 0.0;
};
/// Friction of a disk that slides with v and turns with w; `slip` = |v| / (|w| R), from 0 (turns
/// only) to infinity (slides only). Relative error: force within 4 eps, torque within 16 eps.
/// Real-time safe.
[[nodiscard]] DiskFriction disk_friction(Pressure pressure, double slip) noexcept;

/// Torsional limit / normal force [m] of a disk: 2/3 mu R, or 3 pi/16 mu R.
[[nodiscard]] double disk_torsion_m(Pressure pressure, double friction, double radius_m) noexcept;

}  // namespace isograsp
