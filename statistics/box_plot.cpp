// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/box_plot.hpp"

#include <algorithm>

#include "core/ties.hpp"
#include "statistics/percentile.hpp"

namespace isograsp::statistics {

std::optional<BoxPlot> box_plot(std::span<const double> values) {
  if (values.empty()) return {};
  BoxPlot box;
  box.lower_quartile = *percentile(values, 25.0).value;
  box.median = *median(values).value;
  box.upper_quartile = *percentile(values, 75.0).value;
  const double reach =
      kWhiskerReach * (box.upper_quartile - box.lower_quartile) + tie_width(values);
  box.lower_whisker = box.lower_quartile;
  box.upper_whisker = box.upper_quartile;
  for (const double value : values) {
    if (value < box.lower_quartile - reach || value > box.upper_quartile + reach) {
      box.outside.push_back(value);
      continue;
    }
    box.lower_whisker = std::min(box.lower_whisker, value);
    box.upper_whisker = std::max(box.upper_whisker, value);
  }
  std::sort(box.outside.begin(), box.outside.end());
  return box;
}

}  // namespace isograsp::statistics
