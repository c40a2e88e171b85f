// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/pinch.hpp"

#include <cmath>

#include "grasp_model/limit_surface.hpp"

namespace isograsp::virtual_hand {

namespace {

/// Slip |v| / (|w| R) at which a disk bears torque and force in the ratio `lever` = torque / (force
/// R) [0, infinity): the ratio falls with the slip. To the last bit.
double slip_of(double lever) noexcept {
  const auto ratio = [](double slip) {
    const DiskFriction share = disk_friction(Pressure::uniform, slip);
    return share.torque / share.force;
  };
  double below = 0.0;
  double above = 1.0;
  while (ratio(above) > lever) above *= 2.0;
  while (true) {
    const double middle = 0.5 * (below + above);
    if (!(middle > below && middle < above)) return middle;
    (ratio(middle) > lever ? below : above) = middle;
  }
}

}  // namespace

LeastPinchForce least_pinch_force(const Pinch& pinch) noexcept {
  const double load_N = 0.5 * pinch.mass_kg * pinch.gravity_m_s2;
  const double lever = std::abs(pinch.offset_m) / pinch.patch_radius_m;
  LeastPinchForce least;
  const double share = lever > 0.0 ? disk_friction(Pressure::uniform, slip_of(lever)).force : 1.0;
  least.exact_N = load_N / (pinch.friction * share);
  constexpr double kTorsion = 2.0 / 3.0;  // of a disk: torsional limit / (mu N R)
  least.ellipsoid_N = load_N / pinch.friction * std::hypot(1.0, lever / kTorsion);
  return least;
}

}  // namespace isograsp::virtual_hand
