// SPDX-License-Identifier: GPL-3.0-or-later
// held(t) = mean of the rows in [t - 0.1 s, t + 0.1 s]
#include "kinematics/range_of_motion.hpp"

#include <cmath>

#include "kinematics/pose_series.hpp"

namespace isograsp {

namespace {

void widen(std::optional<double>& least, std::optional<double>& most, double value) {
  if (!least || value < *least) least = value;
  if (!most || value > *most) most = value;
}

}  // namespace

Range range_of_motion(std::span<const double> t_s, std::span<const double> angle_rad) {
  constexpr double kHalfWindow_s = 0.1;
  Range range;
  std::size_t first = 0;  // of the window
  std::size_t end = 0;
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    if (!std::isnan(angle_rad[row])) widen(range.min_rad, range.max_rad, angle_rad[row]);
    const double from_s = t_s[row] - kHalfWindow_s - kMarkerTimeSlack_s;
    const double to_s = t_s[row] + kHalfWindow_s + kMarkerTimeSlack_s;
    while (t_s[first] < from_s) ++first;
    while (end < t_s.size() && t_s[end] <= to_s) ++end;
    if (from_s < t_s.front() - 2.0 * kMarkerTimeSlack_s ||
        to_s > t_s.back() + 2.0 * kMarkerTimeSlack_s)
      continue;
    double sum = 0.0;
    for (std::size_t k = first; k < end; ++k) sum += angle_rad[k];
    const double mean = sum / static_cast<double>(end - first);
    if (!std::isnan(mean)) widen(range.min_held_rad, range.max_held_rad, mean);
  }
  return range;
}

}  // namespace isograsp
