// SPDX-License-Identifier: GPL-3.0-or-later
// What a measured finger force does at its contact: hysteresis, friction clamp. Contact frame: z
// into the object, pressing is +z. SI units. Formulas: docs/grasp_model.md, "Contacts".
#pragma once

#include <array>

#include "core/spatial.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp {

/// Hysteresis: on when f_z > threshold, off when f_z <= threshold / 2. Real-time safe.
class TouchRule {
 public:
  TouchRule() = default;
  explicit TouchRule(double threshold_N) noexcept : least_N_{threshold_N, 0.5 * threshold_N} {}
  [[nodiscard]] bool touches(bool was, double fz_N) const noexcept {
    return fz_N > least_N_[was ? 1 : 0];
  }

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

/// (f_t / mu f_z)^2 + (t_z / gamma f_z)^2 <= 1, without root or division, for a pressing finger.
/// False also where a product might leave the doubles, or a value is not finite: then ask
/// clamp_to_friction. `torsion` = false: the limit is known to have none. Real-time safe.
template <bool torsion = true>
[[nodiscard]] inline bool surely_held(const FrictionLimit& limit, const Wrench& F_C) noexcept {
  constexpr double kLeast = 1e-140;  // its square, and that of its inverse, are normal numbers
  const double fx = F_C.force.x();
  const double fy = F_C.force.y();
  const double fz = F_C.force.z();
  const double tangential = fx * fx + fy * fy;
  const double holds = limit.mu * fz;
  const double holds_squared = holds * holds;
  if (!(holds_squared > kLeast && holds_squared < 1.0 / kLeast)) return false;
  if (!torsion || !limit.torsional) return tangential <= holds_squared;
  const double turns = limit.gamma_m * fz;
  const double turns_squared = turns * turns;
  if (!(turns_squared > kLeast && turns_squared < 1.0 / kLeast)) return false;
  const double tz = F_C.torque.z();
  return tangential * turns_squared + tz * tz * holds_squared <= holds_squared * turns_squared;
}

/// Radial clamp of the tangential force to mu f_z at the measured f_z (never a projection that
/// would invent grip); with torsion: of (f_t, t_z) to the ellipsoid. Zero for f_z <= 0. Real-time
/// safe; squares that leave the doubles are met too, inputs that are not finite are not.
[[nodiscard]] ContactForce clamp_to_friction(const FrictionLimit& limit,
                                             const Wrench& F_C) noexcept;

/// Share of the friction limit that a measured wrench asks for; > 1: the clamp acts. Infinite if a
/// limit of zero is loaded; 0 for f_z <= 0 and where nothing is limited. Real-time safe.
[[nodiscard]] double utilisation(const FrictionLimit& limit, const Wrench& F_C) noexcept;

}  // namespace isograsp
