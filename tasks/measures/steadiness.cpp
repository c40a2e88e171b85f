// SPDX-License-Identifier: GPL-3.0-or-later
// With the fitted line of a force (slope, mean, SD about it):
//   floor = 100 noise_sd / |mean|,  fall = -100 slope (t_last - t_first) / mean
#include "tasks/measures/steadiness.hpp"

#include <cmath>

#include "statistics/line.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

Steadiness steadiness(std::span<const double> t_s, std::span<const double> x,
                      std::optional<double> noise_sd) {
  constexpr double kLargestFloor = 1.0 / 3.0;  // of the CV
  const statistics::Computed variation = cv(t_s, x);
  const auto line = statistics::fit_line(t_s, x);
  if (!line) return {variation, variation, variation, variation};
  if (!variation.value) return {line->residual_sd, variation, variation, variation};
  const double fall_percent = -100.0 * line->slope * (t_s.back() - t_s.front()) / line->mean;
  if (!noise_sd)
    return {line->residual_sd, variation, "the noise of the empty device was not measured"_text,
            fall_percent};
  const double floor_percent = 100.0 * *noise_sd / std::abs(line->mean);
  const bool resolved = floor_percent <= kLargestFloor * std::abs(*variation.value);
  return {line->residual_sd,
          resolved ? variation
                   : statistics::Computed("below resolution: the noise exceeds a third of it"_text),
          floor_percent, fall_percent};
}

}  // namespace isograsp::tasks
