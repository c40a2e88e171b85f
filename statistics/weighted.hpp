// SPDX-License-Identifier: GPL-3.0-or-later
// Means over time.
#pragma once

#include <span>
#include <utility>

#include "statistics/samples.hpp"

namespace isograsp::statistics {

/// sum(w_k f(k)) / sum(w_k), unit of f; `weight` are hold lengths.
template <class Function>
[[nodiscard]] Computed weighted_mean_of(std::span<const double> weight, Function&& f) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    sum += weight[k] * f(k);
    total += weight[k];
  }
  if (!(total > 0.0)) return "no samples"_text;
  return sum / total;
}

}  // namespace isograsp::statistics
