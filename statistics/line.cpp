// SPDX-License-Identifier: GPL-3.0-or-later
// Least squares over n points (t, x) with the means t_mean and mean:
//   slope = sum (t - t_mean) (x - mean) / sum (t - t_mean)^2
//   residual_sd = sqrt(sum (x - mean - slope (t - t_mean))^2 / (n - 1))
#include "statistics/line.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace isograsp::statistics {

std::optional<Line> fit_line(std::span<const double> t_s, std::span<const double> x) {
  assert(t_s.size() == x.size());
  const std::size_t n = x.size();
  if (n < 3) return std::nullopt;
  Line line;
  for (std::size_t k = 0; k < n; ++k) {
    line.t_mean_s += t_s[k];
    line.mean += x[k];
  }
  line.t_mean_s /= static_cast<double>(n);
  line.mean /= static_cast<double>(n);
  double tt = 0.0;
  double tx = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    tt += (t_s[k] - line.t_mean_s) * (t_s[k] - line.t_mean_s);
    tx += (t_s[k] - line.t_mean_s) * (x[k] - line.mean);
  }
  line.slope = tx / tt;
  double squares = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double residual = x[k] - line.mean - line.slope * (t_s[k] - line.t_mean_s);
    squares += residual * residual;
  }
  line.residual_sd = std::sqrt(squares / static_cast<double>(n - 1));
  return line;
}

}  // namespace isograsp::statistics
