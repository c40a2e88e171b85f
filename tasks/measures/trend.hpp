// SPDX-License-Identifier: GPL-3.0-or-later
// Robust trends over few points, such as sessions. Cost grows with the square of their number.
#pragma once

#include <optional>
#include <span>

namespace isograsp {

/// Limits between which a slope lies with the confidence asked for.
struct SlopeInterval {
  double lower = 0.0;
  double upper = 0.0;
};
/// Median of the slopes of all pairs of points with different x, version 1, and the line of that
/// slope through the medians of x and y. (Theil 1950; Sen 1968)
struct Trend {
  double slope = 0.0;  ///< unit of y per unit of x
  double intercept = 0.0;
  std::optional<SlopeInterval> interval;  ///< none: too few points for the confidence
};
/// The interval's ends are order statistics of the slopes, chosen by the distribution of Kendall's
/// S: exact up to 50 points with different x, else its normal approximation with Sen's variance.
/// None with fewer than two different x. @pre x.size() == y.size(), 0 < confidence < 1
[[nodiscard]] std::optional<Trend> theil_sen(std::span<const double> x, std::span<const double> y,
                                             double confidence = 0.95);

}  // namespace isograsp
