// SPDX-License-Identifier: GPL-3.0-or-later
// e = reproduced - target: constant error = mean of e, absolute error = mean of |e|, variable error
// = SD of e.
#include "tasks/measures/force_sense.hpp"

#include <cassert>
#include <cmath>

#include "tasks/measures/onset.hpp"

namespace isograsp::tasks {

ForceSense force_sense(std::span<const double> target, std::span<const double> reproduced) {
  assert(target.size() == reproduced.size());
  const std::size_t n = target.size();
  if (n == 0) return {"no repetitions"_text, "no repetitions"_text, "no repetitions"_text};
  std::vector<double> error(n);
  double sum = 0.0;
  double absolute = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    error[k] = reproduced[k] - target[k];
    sum += error[k];
    absolute += std::abs(error[k]);
  }
  const auto spread = resting_level(error);
  return {
      sum / static_cast<double>(n), absolute / static_cast<double>(n),
      spread ? statistics::Computed(spread->sd) : statistics::Computed("one repetition only"_text)};
}

}  // namespace isograsp::tasks
