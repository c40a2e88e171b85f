// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isograsp {

StepResponse step_response(std::span<const double> t_s, std::span<const double> y,
                           double final_value) {
  assert(t_s.size() == y.size() && !y.empty() && final_value != 0.0);
  const auto first_crossing = [&](double share) -> std::optional<double> {
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double here = y[k] / final_value;
      if (here < share) continue;
      if (k == 0) return t_s[0];
      const double before = y[k - 1] / final_value;
      return t_s[k - 1] + (share - before) / (here - before) * (t_s[k] - t_s[k - 1]);
    }
    return std::nullopt;
  };
  StepResponse response;
  response.t10_s = first_crossing(0.1);
  response.t63_s = first_crossing(1.0 - 1.0 / std::numbers::e);
  response.t90_s = first_crossing(0.9);
  if (response.t10_s && response.t90_s) response.rise10_90_s = *response.t90_s - *response.t10_s;
  constexpr double kSettled = 0.02;
  std::size_t settled_from = y.size();
  while (settled_from > 0 && std::abs(y[settled_from - 1] / final_value - 1.0) <= kSettled)
    --settled_from;
  if (settled_from < y.size()) response.settle2pct_s = t_s[settled_from];
  for (const double value : y)
    response.overshoot = std::max(response.overshoot, value / final_value - 1.0);
  return response;
}

}  // namespace isograsp
