// SPDX-License-Identifier: GPL-3.0-or-later
// What a measured finger force does at its contact: hysteresis, friction clamp. Contact frame: z
// into the object, pressing is +z. SI units. Formulas: docs/grasp_model.md, "Contacts".
#pragma once

#include <array>
#include <cmath>

#include "core/spatial.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp {

/// Hysteresis: on when f_z > threshold, off when f_z <= threshold / 2. Real-time safe.
class TouchRule {
 public:
  TouchRule() = default;
  explicit TouchRule(double threshold_N) noexcept : least_N_{threshold_N, 0.5 * threshold_N} {}
  [[nodiscard]] bool touches(bool was, double fz_N) const noexcept { return fz_N > least_N(was); }
  [[nodiscard]] double least_N(bool was) const noexcept { return least_N_[was ? 1 : 0]; }

 private:
  std::array<double, 2> least_N_{};  ///< to touch, to stay
};

/// What a contact can hold.
struct FrictionLimit {
  FrictionLimit() = default;
  explicit FrictionLimit(const Contact& contact) noexcept;

  bool tangential = false;  ///< point, soft: f_x and f_y pass
  bool torsional = false;   ///< soft with a torsional limit: t_z passes
  double mu = 0.0;
  double gamma_m = 0.0;  ///< torsional limit / normal force
};

/// Force coordinates that a contact transmits, contact axes [N, N, N, N m].
struct ContactForce {
  double fx = 0.0;
  double fy = 0.0;
  double fz = 0.0;
  double tz = 0.0;
  bool slip = false;  ///< the clamp acted
};

/// All components that the contact transmits are finite.
[[nodiscard]] inline bool usable(const FrictionLimit& limit, const Wrench& F_C) noexcept {
  const Vec3& f = F_C.force;
  return std::isfinite(f.z()) &&
         (!limit.tangential || (std::isfinite(f.x()) && std::isfinite(f.y()))) &&
         (!limit.torsional || std::isfinite(F_C.torque.z()));
}

/// Radial clamp of the tangential force to mu f_z at the measured f_z (never a projection that
/// would invent grip); with torsion: of (f_t, t_z) to the ellipsoid. Zero for f_z <= 0. Real-time
/// safe; right also where squares over- or underflow, but not for inputs that are not finite.
[[nodiscard]] ContactForce clamp_to_friction(const FrictionLimit& limit,
                                             const Wrench& F_C) noexcept;

/// Share of the friction limit that a measured wrench asks for; > 1: the clamp acts. Infinite if a
/// limit of zero is loaded; 0 for f_z <= 0 and where nothing is limited. Real-time safe.
[[nodiscard]] double utilisation(const FrictionLimit& limit, const Wrench& F_C) noexcept;

}  // namespace isograsp
