// SPDX-License-Identifier: GPL-3.0-or-later
// rise: mean of a digit's force in a hold less its force at the start of the hold:
//   enslaving of i by j = mean of rise_i / rise_j over the holds of j
//   uninstructed deviation = sqrt(sum w (force - start)^2 / sum w) over the digits not asked for
#include "tasks/measures/coordination/digits.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/quantile.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

double rise_of(const DigitHold& hold, Finger finger) {
  return hold.mean_N[index_of(finger)] - hold.start_N[index_of(finger)];
}

}  // namespace

statistics::Computed enslaving(std::span<const DigitHold> holds, Finger i, Finger j,
                               double least_rise_N) {
  double sum = 0.0;
  int count = 0;
  for (const DigitHold& hold : holds) {
    const double rise_N = rise_of(hold, j);
    if (hold.instructed != j || !(rise_N > 0.0) || rise_N < least_rise_N) continue;
    sum += rise_of(hold, i) / rise_N;
    ++count;
  }
  if (count == 0) return "there was no hold in which the instructed digit pressed"_text;
  return sum / count;
}

statistics::Computed enslaving_of_maximum(std::span<const DigitHold> holds, Finger i, Finger j,
                                          double maximum_i_N) {
  if (!(maximum_i_N > 0.0)) return "the maximum of the digit is not known"_text;
  double sum_N = 0.0;
  int count = 0;
  for (const DigitHold& hold : holds) {
    if (hold.instructed != j) continue;
    sum_N += rise_of(hold, i);
    ++count;
  }
  if (count == 0) return "there was no hold of the instructed digit"_text;
  return sum_N / count / maximum_i_N;
}

statistics::Computed uninstructed_deviation(const DigitForces& forces, Finger instructed,
                                            const PerDigit& start_N) {
  double squares = 0.0;
  double total = 0.0;
  for (const Finger finger : kFingers) {
    if (finger == instructed) continue;
    const std::size_t i = index_of(finger);
    assert(forces.force_N[i].size() == forces.weight.size());
    for (std::size_t k = 0; k < forces.weight.size(); ++k) {
      const double off_N = forces.force_N[i][k] - start_N[i];
      squares += forces.weight[k] * off_N * off_N;
      total += forces.weight[k];
    }
  }
  if (!(total > 0.0)) return "no samples"_text;
  return std::sqrt(squares / total);
}

statistics::Computed individuation_slope(std::span<const Individuation> holds) {
  constexpr std::size_t kLeastHolds = 3;  // of two, neither is an outlier
  std::vector<double> ratio;
  std::vector<double> force_N;
  for (const Individuation& hold : holds) {
    if (!(hold.instructed_N > 0.0)) continue;
    ratio.push_back(hold.deviation_N / hold.instructed_N);
    force_N.push_back(hold.instructed_N);
  }
  if (ratio.size() < kLeastHolds) return "fewer than three holds with force"_text;
  constexpr double kHalf = 0.5;
  return statistics::quantile(ratio, force_N, kHalf);
}

statistics::Computed individuation_index(std::span<const Individuation> holds) {
  const statistics::Computed slope = individuation_slope(holds);
  if (!slope.value) return slope;
  if (!(*slope.value > 0.0)) return "the other digits did not move"_text;
  return -std::log(*slope.value);
}

statistics::Computed coflexion(const DigitForces& forces, const std::vector<bool>& valid,
                               double window_s) {
  std::vector<double> pull_N(forces.weight.size(), 0.0);
  double press_N = 0.0;
  for (const auto& force_N : forces.force_N) {
    assert(force_N.size() == forces.weight.size());
    for (std::size_t k = 0; k < pull_N.size(); ++k) pull_N[k] += std::max(0.0, -force_N[k]);
    const statistics::Computed best = best_moving_mean(force_N, forces.weight, valid, window_s);
    press_N = std::max(press_N, best.value.value_or(0.0));
  }
  const statistics::Computed opening_N = best_moving_mean(pull_N, forces.weight, valid, window_s);
  if (!opening_N.value) return opening_N;
  if (!(*opening_N.value > 0.0)) return "there was no opening force"_text;
  return 100.0 * press_N / *opening_N.value;
}

statistics::Computed sharing(const PerDigit& mean_N, Finger finger) {
  double sum_N = 0.0;
  for (const double force_N : mean_N) sum_N += force_N;
  if (!(sum_N > 0.0)) return "the digits did not press"_text;
  return 100.0 * mean_N[index_of(finger)] / sum_N;
}

statistics::Computed thumb_opposition(const PerDigit& mean_N) {
  const double fingers_N = mean_N[index_of(Finger::index)] + mean_N[index_of(Finger::middle)];
  if (!(fingers_N > 0.0)) return "the fingers did not press"_text;
  return mean_N[index_of(Finger::thumb)] / fingers_N;
}

}  // namespace isograsp::tasks
