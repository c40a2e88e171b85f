// SPDX-License-Identifier: GPL-3.0-or-later
// Means over time of |actual - target| and of angles; over one or several paths of positions p_k:
//   path efficiency = 100 sum |p_last - p_first| / sum |p_k - p_(k - 1)|
#include "tasks/measures/motion.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "statistics/weighted.hpp"
#include "tasks/measures/coordination/direction.hpp"

namespace isograsp::tasks {

statistics::Computed mean_distance(std::span<const Vec3> actual_m, std::span<const Vec3> target_m,
                                   std::span<const double> weight) {
  assert(actual_m.size() == weight.size() && target_m.size() == weight.size());
  return statistics::weighted_mean_of(
      weight, [&](std::size_t k) { return (actual_m[k] - target_m[k]).norm(); });
}

statistics::Computed mean_angle(std::span<const Quat> actual, std::span<const Quat> target,
                                std::span<const double> weight) {
  assert(actual.size() == weight.size() && target.size() == weight.size());
  return statistics::weighted_mean_of(
      weight, [&](std::size_t k) { return angle_between(actual[k], target[k]); });
}

double axis_angle(const Quat& a, const Quat& b, const Vec3& axis_O) {
  return angle_of(a * axis_O, b * axis_O);
}

statistics::Computed mean_axis_angle(std::span<const Quat> actual, std::span<const Quat> target,
                                     const Vec3& axis_O, std::span<const double> weight,
                                     bool either_way) {
  assert(actual.size() == weight.size() && target.size() == weight.size());
  return statistics::weighted_mean_of(weight, [&](std::size_t k) {
    const double angle = axis_angle(actual[k], target[k], axis_O);
    return either_way ? std::min(angle, std::numbers::pi - angle) : angle;
  });
}

statistics::Computed rms_angle(std::span<const Quat> actual, std::span<const Quat> target,
                               std::span<const double> weight) {
  assert(actual.size() == weight.size() && target.size() == weight.size());
  double squares = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    const double angle_rad = angle_between(actual[k], target[k]);
    squares += weight[k] * angle_rad * angle_rad;
    total += weight[k];
  }
  if (!(total > 0.0)) return "no samples"_text;
  return std::sqrt(squares / total);
}

double path_length(std::span<const Vec3> position_m) {
  double length_m = 0.0;
  for (std::size_t k = 1; k < position_m.size(); ++k) {
    const Vec3 d = position_m[k] - position_m[k - 1];
    // In this order: the order in norm() depends on the version of Eigen, and with it the last bit.
    length_m += std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
  }
  return length_m;
}

statistics::Computed path_efficiency(std::span<const std::vector<Vec3>> paths_m) {
  double straight_m = 0.0;
  double length_m = 0.0;
  for (const auto& path_m : paths_m) {
    if (path_m.empty()) continue;
    straight_m += path_length(std::array{path_m.front(), path_m.back()});
    length_m += path_length(path_m);
  }
  if (!(length_m > 0.0)) return "nothing moved"_text;
  return 100.0 * straight_m / length_m;
}

}  // namespace isograsp::tasks
