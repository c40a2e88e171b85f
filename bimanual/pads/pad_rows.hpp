// SPDX-License-Identifier: GPL-3.0-or-later
// Inside bimanual/pads/ only: what the solvers share: rows at a point, and what is called settled.
#pragma once

#include <Eigen/Core>

#include "bimanual/pads/pad_step.hpp"

namespace isograsp::bimanual {

/// Of the largest velocity: what may be left.
inline constexpr double kSettled = 1e-10;
/// Bodies slower than this stand still: what a sweep changes is compared with it [m/s], [rad/s].
inline constexpr double kStill = 1e-3;

/// How a direction at a point moves with a body.
inline Vec6 row_of(const Vec3& direction, const Vec3& arm) {
  Vec6 row;
  row << direction, arm.cross(direction);
  return row;
}

inline Vec3 velocity_at(const Vec6& v, const Vec3& arm) {
  return v.head<3>() + v.tail<3>().cross(arm);
}
inline Vec3 across(const Vec3& v, const Vec3& normal) {
  return v - normal.dot(v) * normal;
}

}  // namespace isograsp::bimanual
