// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/attempts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isograsp::tasks {

bool attempts_agree(std::span<const double> attempts, double percent, Compared compared) {
  if (attempts.size() < 2) return false;
  std::array<double, 2> two{attempts[attempts.size() - 2], attempts.back()};
  if (compared == Compared::best_two) {
    const auto best = std::max_element(attempts.begin(), attempts.end());
    two = {*best, -std::numeric_limits<double>::infinity()};
    for (auto one = attempts.begin(); one != attempts.end(); ++one)
      if (one != best) two[1] = std::max(two[1], *one);
  }
  const double larger = std::max(std::abs(two[0]), std::abs(two[1]));
  return 100.0 * std::abs(two[0] - two[1]) <= percent * larger;
}

}  // namespace isograsp::tasks
