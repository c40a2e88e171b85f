// SPDX-License-Identifier: GPL-3.0-or-later
// With the m values in ascending order, p_(1) <= ... <= p_(m):
//   adjusted p_(k) = max over j <= k of min(1, (m - j + 1) p_(j))
#include "statistics/holm.hpp"

#include <algorithm>
#include <cstddef>

namespace isograsp::statistics {

std::vector<std::optional<double>> holm(std::span<const std::optional<double>> p) {
  std::vector<std::size_t> ascending;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (p[i]) ascending.push_back(i);
  std::stable_sort(ascending.begin(), ascending.end(),
                   [&](std::size_t a, std::size_t b) { return *p[a] < *p[b]; });
  std::vector<std::optional<double>> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t k = 0; k < ascending.size(); ++k) {
    const auto left = static_cast<double>(ascending.size() - k);
    largest = std::max(largest, std::min(1.0, left * *p[ascending[k]]));
    adjusted[ascending[k]] = largest;
  }
  return adjusted;
}

}  // namespace isograsp::statistics
