// SPDX-License-Identifier: GPL-3.0-or-later
// Where the object of a task is to be brought, and how near is near enough. SI units, radians.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/spatial.hpp"
#include "tasks/pace.hpp"

namespace isograsp::tasks {

/// How near is near enough.
struct PoseTolerance {
  double position_m = 0.0;
  double angle_rad = 0.0;
  [[nodiscard]] bool holds(const Pose& X_WT, const Pose& X_WO) const noexcept {
    return (X_WO.p - X_WT.p).norm() <= position_m && angle_between(X_WT.q, X_WO.q) <= angle_rad;
  }
};

/// One target of an object that stands still.
struct TargetPlace {
  std::optional<Vec3> p_WO;  ///< the object appears there [m]; nothing: it is where it was
  Vec3 p_WT = Vec3::Zero();  ///< [m]
  double angle_rad = 0.0;    ///< about world z
  bool held = false;         ///< for a while, inside the tolerance
};

/// How heavy an object is made that two hands lift: at this height above its rest each hand is
/// asked for `level` of the maximum of the weaker one.
struct HandsLoad {
  double level = 0.0;
  double height_m = 0.0;
};

/// How long it takes to bring an object to its targets one after the other: half the time allowed,
/// as a rule.
[[nodiscard]] inline Duration duration_of_targets(double limit_s, std::size_t count) noexcept {
  constexpr double kUsualShare = 0.5;
  const double worst_s = limit_s * static_cast<double>(count);
  return {kUsualShare * worst_s, worst_s};
}

/// How the target of an object moves in one degree of freedom.
struct AxisCourse {
  int axis = 0;                ///< 0 … 5: x y z [m], turns about world x y z [rad]
  std::vector<double> values;  ///< one per frame
};

}  // namespace isograsp::tasks
