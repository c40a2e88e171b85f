// SPDX-License-Identifier: GPL-3.0-or-later
//   index of difficulty = log2(distance / width + 1),  width = 2 tolerance
//   effective width = sqrt(2 pi e) SD of the errors = 4.133 SD
//   throughput = log2(mean distance / effective width + 1) / mean time
#include "tasks/measures/fitts.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::tasks {

namespace {

template <class Field>
double mean_of(std::span<const AimedTrial> trials, Field field) {
  double sum = 0.0;
  for (const AimedTrial& trial : trials) sum += trial.*field;
  return sum / static_cast<double>(trials.size());
}

statistics::Computed difficulty(double distance, double width) {
  return std::log2(distance / width + 1.0);
}

}  // namespace

statistics::Computed index_of_difficulty(double distance, double tolerance) {
  if (!(tolerance > 0.0)) return "the target has no width"_text;
  if (!(distance >= 0.0)) return "the distance is negative"_text;
  return difficulty(distance, 2.0 * tolerance);
}

statistics::Computed effective_width(std::span<const AimedTrial> trials) {
  constexpr std::size_t kLeastTrials = 10;  // the SD of ten is known to about a quarter
  constexpr double kWidthOfSd = 4.133;      // sqrt(2 pi e): as much information as a uniform width
  if (trials.size() < kLeastTrials) return "fewer than ten trials"_text;
  const double mean = mean_of(trials, &AimedTrial::error);
  double squares = 0.0;
  double largest = 0.0;
  for (const AimedTrial& trial : trials) {
    squares += (trial.error - mean) * (trial.error - mean);
    largest = std::max(largest, std::abs(trial.error));
  }
  const double sd = std::sqrt(squares / static_cast<double>(trials.size() - 1));
  constexpr double kConstant = 1e-13;  // rounding of the mean of equal errors
  if (!(sd > kConstant * largest)) return "the end points do not vary"_text;
  return kWidthOfSd * sd;
}

statistics::Computed throughput(std::span<const AimedTrial> trials) {
  const statistics::Computed width = effective_width(trials);
  if (!width.value) return width;
  const double distance = mean_of(trials, &AimedTrial::distance);
  const double time_s = mean_of(trials, &AimedTrial::time_s);
  if (!(distance > 0.0 && time_s > 0.0)) return "nothing moved"_text;
  return *difficulty(distance, *width.value).value / time_s;
}

}  // namespace isograsp::tasks
