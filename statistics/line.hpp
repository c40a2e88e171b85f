// SPDX-License-Identifier: GPL-3.0-or-later
// Straight lines by least squares.
#pragma once

#include <optional>
#include <span>

namespace isograsp::statistics {

/// x = mean + slope (t - t_mean), every sample counting alike.
struct Line {
  double t_mean_s = 0.0;
  double mean = 0.0;
  double slope = 0.0;        ///< unit of x per s
  double residual_sd = 0.0;  ///< n - 1
};
/// None through fewer than three samples. @pre times increase strictly
[[nodiscard]] std::optional<Line> fit_line(std::span<const double> t_s, std::span<const double> x);

}  // namespace isograsp::statistics
