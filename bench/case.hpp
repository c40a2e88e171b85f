// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as every engine gets it: body, springs, dampers, one wrench per hold, and where the
// object really is after each hold. Frames: W world, O object. SI units.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace isograsp::bench {

using Triple = std::array<double, 3>;

/// Wrench on the object about its COM during one hold, after friction clamp and grasp map.
struct Push {
  Triple force{};   ///< [N], world axes or, if Case::follows, object axes
  Triple torque{};  ///< [N m], same axes
};

/// Where the object is and how it moves.
struct Motion6 {
  Triple p_WO{};                           ///< [m]
  std::array<double, 4> q_WO{1, 0, 0, 0};  ///< w x y z
  Triple v_WO_W{};                         ///< [m/s]
  Triple w_WO_W{};                         ///< [rad/s], world axes
};

struct Case {
  std::string name;
  std::string title;
  std::string scene_file;  ///< what the product itself compiles
  bool peers = true;       ///< other engines take part
  bool follows = false;    ///< the wrench is constant in object axes, not in world axes
  double hold_s = 0.0;
  double mass_kg = 0.0;
  Triple inertia_kg_m2{};             ///< principal
  std::array<bool, 6> free{};         ///< x y z rx ry rz; the others are locked
  std::array<double, 6> stiffness{};  ///< [N/m], [N m/rad]; at rest at the origin
  std::array<double, 6> damping{};    ///< [N s/m], [N m s/rad]
  Motion6 start;
  double excursion_m = 0.0;    ///< largest distance from the origin in the reference
  double excursion_rad = 0.0;  ///< largest angle from the identity in the reference
  std::vector<std::array<double, 9>> fingers;  ///< thumb, index, middle: fx fy fz [N], per hold
  std::vector<Push> pushes;                    ///< per hold
  std::vector<Motion6> reference;              ///< at the end of each hold

  [[nodiscard]] int free_rotations() const { return free[3] + free[4] + free[5]; }
  [[nodiscard]] int free_translations() const { return free[0] + free[1] + free[2]; }
  /// Uncoupled degrees of freedom with constant coefficients, the rotation about z alone.
  [[nodiscard]] bool linear() const { return free_rotations() <= 1; }
};

void write_case(const Case& scene, const std::string& path);
/// Throws std::runtime_error if the file is not a case.
[[nodiscard]] Case read_case(const std::string& path);

/// Distance [m] and geodesic angle [rad] between two poses; exact also for tiny angles.
struct Distance {
  double metres = 0.0;
  double radians = 0.0;
};
[[nodiscard]] Distance distance(const Motion6& a, const Motion6& b);

/// Energy [J] and angular momentum in world axes [N m s] of the turning body.
struct Conserved {
  double energy = 0.0;
  Triple momentum{};
};
[[nodiscard]] Conserved conserved(const Case& scene, const Motion6& motion);

// The few operations on attitudes that engines without such functions need.
[[nodiscard]] inline Triple turn(const std::array<double, 4>& q, const Triple& u) {
  const auto [w, x, y, z] = q;
  const Triple t{2 * (y * u[2] - z * u[1]), 2 * (z * u[0] - x * u[2]), 2 * (x * u[1] - y * u[0])};
  return {u[0] + w * t[0] + y * t[2] - z * t[1], u[1] + w * t[1] + z * t[0] - x * t[2],
          u[2] + w * t[2] + x * t[1] - y * t[0]};
}
[[nodiscard]] inline std::array<double, 4> inverse(const std::array<double, 4>& q) {
  return {q[0], -q[1], -q[2], -q[3]};
}
/// Rotation vector [rad] in the principal branch: what all engines use, and all scenes stay in it.
[[nodiscard]] inline Triple log(const std::array<double, 4>& q) {
  const double sine = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (sine == 0.0) return {};
  const double sign = q[0] < 0.0 ? -1.0 : 1.0;
  const double scale = sign * 2.0 * std::atan2(sine, sign * q[0]) / sine;
  return {scale * q[1], scale * q[2], scale * q[3]};
}

}  // namespace isograsp::bench
