// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of subjects for the tests of group statistics: seeded ones, and how uniform p values are.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.hpp"
#include "statistics/subject_table.hpp"

namespace isograsp::test {

/// Every subject has a level of its own; conditions do not differ. Standard deviation 1 each.
inline statistics::SubjectTable null_table(Random& random, Eigen::Index subjects,
                                           Eigen::Index conditions) {
  statistics::SubjectTable table(subjects, conditions);
  for (Eigen::Index row = 0; row < subjects; ++row) {
    const double level = random.gaussian();
    for (Eigen::Index column = 0; column < conditions; ++column)
      table(row, column) = level + random.gaussian();
  }
  return table;
}

/// The rows of `table` in another order.
inline statistics::SubjectTable turned(const statistics::SubjectTable& table) {
  return table.colwise().reverse();
}

/// Kolmogorov's distance of the values from the uniform distribution, times √n.
inline double distance_from_uniform(std::vector<double> p) {
  std::sort(p.begin(), p.end());
  const auto n = static_cast<double>(p.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto below = static_cast<double>(i);
    distance = std::max({distance, (below + 1.0) / n - p[i], p[i] - below / n});
  }
  return distance * std::sqrt(n);
}
/// Exceeded by uniform values once in a thousand seeds (Kolmogorov's distribution).
inline constexpr double kLargestDistance = 1.95;

}  // namespace isograsp::test
