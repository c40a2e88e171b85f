// SPDX-License-Identifier: GPL-3.0-or-later
// Forces f with weights w, direction d of length 1, f_0 the first and f_n the last force:
//   angle = atan2(|a x b|, a . b),  direction error = sum w angle(f, d) / sum w
//   projection ratio = sum w (f . d) / sum w |f|
//   along = (f - f_0) . (f_n - f_0) / |f_n - f_0|^2
//   path deviation = sum w |f - f_0 - along (f_n - f_0)| / sum w
#include "tasks/measures/coordination/direction.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/quantile.hpp"

namespace isograsp::tasks {

double angle_of(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

statistics::Computed direction_error(std::span<const Vec3> force_N, const Vec3& direction,
                                     std::span<const double> weight, double least_N) {
  assert(force_N.size() == weight.size() && direction.norm() > 0.0);
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    if (!(force_N[k].norm() > least_N)) continue;
    sum += weight[k] * angle_of(force_N[k], direction);
    total += weight[k];
  }
  if (!(total > 0.0)) return "there was no force"_text;
  return sum / total;
}

statistics::Computed projection_ratio(std::span<const Vec3> force_N, const Vec3& direction,
                                      std::span<const double> weight) {
  assert(force_N.size() == weight.size() && direction.norm() > 0.0);
  const Vec3 unit = direction.normalized();
  double useful = 0.0;
  double whole = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    useful += weight[k] * force_N[k].dot(unit);
    whole += weight[k] * force_N[k].norm();
  }
  if (!(whole > 0.0)) return "there was no force"_text;
  return useful / whole;
}

statistics::Computed path_deviation(std::span<const std::vector<double>> digits_N,
                                    std::span<const double> weight) {
  if (digits_N.empty() || weight.size() < 2) return "fewer than two samples"_text;
  double length = 0.0;  // squared
  for (const auto& force_N : digits_N) {
    assert(force_N.size() == weight.size());
    length += std::pow(force_N.back() - force_N.front(), 2);
  }
  if (!(length > 0.0)) return "the force ends where it began"_text;
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    double along = 0.0;
    for (const auto& force_N : digits_N)
      along += (force_N[k] - force_N.front()) * (force_N.back() - force_N.front()) / length;
    double squares = 0.0;
    for (const auto& force_N : digits_N)
      squares +=
          std::pow(force_N[k] - force_N.front() - along * (force_N.back() - force_N.front()), 2);
    sum += weight[k] * std::sqrt(squares);
    total += weight[k];
  }
  if (!(total > 0.0)) return "no samples"_text;
  return sum / total;
}

PushSummary summary_of_push(std::span<const double> push_N, std::span<const double> grip_N,
                            std::span<const double> weight, double least_grip_N) {
  assert(push_N.size() == grip_N.size() && grip_N.size() == weight.size() && least_grip_N >= 0.0);
  constexpr double kFlagged = 20.0;  // % of grip: above, arm or trunk took part
  constexpr double kMedian = 0.5;
  std::vector<double> percent;
  std::vector<double> held;
  double above = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    if (!(grip_N[k] > least_grip_N)) continue;
    percent.push_back(100.0 * std::abs(push_N[k]) / grip_N[k]);
    held.push_back(weight[k]);
    total += weight[k];
    if (percent.back() > kFlagged) above += weight[k];
  }
  if (!(total > 0.0)) return {"there was no grip"_text, "there was no grip"_text};
  return {statistics::quantile(percent, held, kMedian), 100.0 * above / total};
}

}  // namespace isograsp::tasks
