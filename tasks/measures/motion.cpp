// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/motion.hpp"

#include <algorithm>
#include <cassert>
#include <numbers>

#include "tasks/measures/direction.hpp"

namespace isograsp {

namespace {

template <class Function>
Computed mean_of(std::span<const double> weight, Function&& f) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    sum += weight[k] * f(k);
    total += weight[k];
  }
  if (!(total > 0.0)) return "no samples";
  return sum / total;
}

}  // namespace

Computed mean_distance(std::span<const Vec3> actual_m, std::span<const Vec3> target_m,
                       std::span<const double> weight) {
  assert(actual_m.size() == weight.size() && target_m.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) { return (actual_m[k] - target_m[k]).norm(); });
}

Computed mean_angle(std::span<const Quat> actual, std::span<const Quat> target,
                    std::span<const double> weight) {
  assert(actual.size() == weight.size() && target.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) { return angle_between(actual[k], target[k]); });
}

double axis_angle(const Quat& a, const Quat& b, const Vec3& axis_O) {
  return angle_of(a * axis_O, b * axis_O);
}

Computed mean_axis_angle(std::span<const Quat> actual, std::span<const Quat> target,
                         const Vec3& axis_O, std::span<const double> weight, bool either_way) {
  assert(actual.size() == weight.size() && target.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) {
    const double angle = axis_angle(actual[k], target[k], axis_O);
    return either_way ? std::min(angle, std::numbers::pi - angle) : angle;
  });
}

double path_length(std::span<const Vec3> position_m) {
  double length_m = 0.0;
  for (std::size_t k = 1; k < position_m.size(); ++k)
    length_m += (position_m[k] - position_m[k - 1]).norm();
  return length_m;
}

Computed path_efficiency(std::span<const Vec3> position_m) {
  const double length_m = path_length(position_m);
  if (!(length_m > 0.0)) return "nothing moved";
  return 100.0 * (position_m.back() - position_m.front()).norm() / length_m;
}

}  // namespace isograsp
