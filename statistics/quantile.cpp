// SPDX-License-Identifier: GPL-3.0-or-later
// The quantile is the least value for which: sum of the weights of all values up to it >= share *
// sum of all weights.
#include "statistics/quantile.hpp"

#include <algorithm>
#include <cassert>

namespace isograsp::statistics {

Computed quantile(std::span<const double> x, std::span<const double> weight, double share) {
  assert(x.size() == weight.size() && share > 0.0 && share <= 1.0);
  struct Weighted {
    double value;
    double weight;
  };
  std::vector<Weighted> all;
  all.reserve(x.size());
  double total = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (weight[k] > 0.0) {
      all.push_back({x[k], weight[k]});
      total += weight[k];
    }
  if (all.empty()) return "no samples"_text;
  constexpr double kRoundingSlack = 1e-9;  // sums in another order reach the share as well
  double missing = share * total - kRoundingSlack * total;
  // The values are not sorted but split in two; only the part that holds the quantile is split
  // again.
  auto first = all.begin();
  auto end = all.end();
  while (end - first > 1) {
    const auto middle = first + (end - first) / 2;
    std::nth_element(first, middle, end,
                     [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double below = 0.0;
    for (auto at = first; at != middle; ++at) below += at->weight;
    if (below >= missing) {
      end = middle;
    } else {
      missing -= below;
      first = middle;
    }
  }
  return first->value;
}

}  // namespace isograsp::statistics
