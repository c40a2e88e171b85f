// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mean.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace isograsp {

double arithmetic_mean(std::span<const double> values) {
  assert(!values.empty());
  const auto count = static_cast<double>(values.size());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  if (std::isfinite(sum)) return sum / count;
  constexpr int kSmaller = -64;  // powers of two: exact; no container holds 2^64 values
  double scaled = 0.0;
  for (const double value : values) scaled += std::ldexp(value, kSmaller);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  // Rounding may take the mean beyond the largest finite number.
  const double mean =
      std::clamp(scaled / count, std::ldexp(*least, kSmaller), std::ldexp(*most, kSmaller));
  return std::ldexp(mean, -kSmaller);
}

}  // namespace isograsp
