// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers behind a box plot: Tukey 1977, with the quartiles of statistics/percentile.hpp.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "statistics/samples.hpp"

namespace isograsp::statistics {

/// Whiskers end at the most distant values within this many box lengths of the box.
inline constexpr double kWhiskerReach = 1.5;
/// The rule in words, for under the plot.
inline constexpr Words kBoxRule =
    "Box: lower quartile, median, upper quartile, at positions 0.25, 0.5 and 0.75 of the way from "
    "the smallest to the largest value, interpolated linearly (Hyndman and Fan 1996, definition "
    "7). Whiskers: most distant values within 1.5 box lengths of the box. Each dot is one subject."_text;

struct BoxPlot {
  double lower_quartile = 0.0;
  double median = 0.0;
  double upper_quartile = 0.0;
  double lower_whisker = 0.0;
  double upper_whisker = 0.0;
  std::vector<double> outside;  ///< beyond the whiskers, smallest first
};
/// Nothing for no values. @pre all finite
[[nodiscard]] std::optional<BoxPlot> box_plot(std::span<const double> values);

}  // namespace isograsp::statistics
