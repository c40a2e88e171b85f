// SPDX-License-Identifier: GPL-3.0-or-later
// When two computed values are the same: means of equal trials differ in their last bits by the
// order in which they were added. Neither a rank nor the choice of the best may depend on that.
// Times within a trial have a rule of their own (statistics/samples.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace isograsp {

/// Values are tied if they differ by no more than this share of the largest of them in size: a
/// thousand times the rounding of a double, far below the last digit of any sensor.
inline constexpr double kTied = 1e-12;

/// The largest difference of values that are tied. Values that are not finite do not count.
[[nodiscard]] inline double tie_width(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values)
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  return kTied * largest;
}

/// No further apart than `width`; equal infinities are tied.
[[nodiscard]] inline bool are_tied(double a, double b, double width) {
  return a == b || std::abs(a - b) <= width;
}
/// The same of two values by themselves.
[[nodiscard]] inline bool are_tied(double a, double b) {
  const double both[] = {a, b};
  return are_tied(a, b, tie_width(both));
}

/// Ranks 1, 2, … of the values; tied ones share the mean of their ranks. Tied are values no more
/// than `width` above the smallest of them. @pre no value is NaN
[[nodiscard]] std::vector<double> mid_ranks(std::span<const double> values, double width);

}  // namespace isograsp
