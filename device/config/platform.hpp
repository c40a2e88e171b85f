// SPDX-License-Identifier: GPL-3.0-or-later
// The platform on which the three sensors stand: the wrench of the whole hand on it, and where on
// its support each pad presses. Frames: P platform (axes x y z of the device), C contact of a
// finger (z along the pressing direction). SI units. Pure and real-time safe.
#pragma once

#include <array>
#include <optional>

#include "core/spatial.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// Where one support's contact frame stands.
struct Support {
  Vec3 p_PC = Vec3::Zero();
  Mat3 R_PC = Mat3::Identity();
};

struct Platform {
  /// Thumb opposite to index and middle, 65 mm apart, the fingers 25 mm apart, as in the paper.
  std::array<Support, kFingerCount> supports;
  Platform();
};

/// Wrench of all fingers on the platform about its origin, in P: F = sum R f, tau = sum (R tau_f +
/// p x R f). It shows how the arm or the trunk pushes, because finger forces that only squeeze
/// cancel in F.
[[nodiscard]] Wrench net_wrench(const Platform& platform, const FingerWrenches& wrench_C) noexcept;

/// Below this force along z the place where a pad presses is not computed (clinical rules,
/// posture).
inline constexpr double kLeastForceForPlace_N = 2.0;
/// Pad centre of pressure on the support, x and y of C: (-tau_y / f_z, tau_x / f_z) [m].
[[nodiscard]] std::optional<Eigen::Vector2d> centre_of_pressure(const Wrench& wrench_C) noexcept;

}  // namespace isograsp
