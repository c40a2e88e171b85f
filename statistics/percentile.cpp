// SPDX-License-Identifier: GPL-3.0-or-later
// n values in order, x_0 to x_(n - 1), counted from 0:
//   position = (n - 1) percent / 100,  rank = floor(position),  part = position - rank
//   percentile = x_rank + part (x_(rank + 1) - x_rank)
#include "statistics/percentile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp::statistics {

Computed percentile(std::span<const double> x, double percent) {
  assert(percent >= 0.0 && percent <= 100.0);
  if (x.empty()) return "no values"_text;
  std::vector<double> values(x.begin(), x.end());
  const double position = static_cast<double>(values.size() - 1) * percent / 100.0;
  const double rank = std::floor(position);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), below, values.end());
  if (below + 1 == values.end()) return *below;
  const double above = *std::min_element(below + 1, values.end());
  const double part = position - rank;
  const double step = above - *below;
  return std::isfinite(step) ? *below + part * step : *below * (1.0 - part) + above * part;
}

Computed median(std::span<const double> x) {
  return percentile(x, 50.0);
}

}  // namespace isograsp::statistics
