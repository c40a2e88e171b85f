// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/attempts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace isograsp {

bool attempts_agree(std::span<const double> attempts, double percent, Compared compared) {
  if (attempts.size() < 2) return false;
  std::array<double, 2> two{attempts[attempts.size() - 2], attempts.back()};
  if (compared == Compared::best_two)
    std::partial_sort_copy(attempts.begin(), attempts.end(), two.begin(), two.end(),
                           std::greater<>());
  const double larger = std::max(std::abs(two[0]), std::abs(two[1]));
  return 100.0 * std::abs(two[0] - two[1]) <= percent * larger;
}

}  // namespace isograsp
