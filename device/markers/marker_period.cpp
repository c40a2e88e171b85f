// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/markers/marker_period.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace isograsp {

double period_of(const std::vector<double>& t_s) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < t_s.size(); ++k) steps.push_back(t_s[k] - t_s[k - 1]);
  std::vector<double> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double median_s = *middle;
  constexpr double kRegular = 0.25;  // of a step: further off it is no step of the grid
  double sum_s = 0.0, count = 0.0;
  for (const double step_s : steps) {
    const double places = std::round(step_s / median_s);
    if (places < 1.0 || std::abs(step_s - places * median_s) > kRegular * median_s) continue;
    sum_s += step_s;
    count += places;
  }
  const double period_s = sum_s / count;
  constexpr double kDigits = 1e-3;  // [s], of the last time of a file that writes milliseconds
  const double rate_Hz = std::round(1.0 / period_s);
  return rate_Hz >= 1.0 && std::abs(1.0 / rate_Hz - period_s) * count < kDigits ? 1.0 / rate_Hz
                                                                                : period_s;
}

}  // namespace isograsp
