// SPDX-License-Identifier: GPL-3.0-or-later
// fresh = mean force of the first 5 s:
//   fatigue slope = 100 (slope of the fitted line) / fresh
//   time to fatigue = when force / fresh < 0.8 begins to last for 1 s
#include "tasks/measures/fatigue.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/line.hpp"
#include "tasks/measures/error.hpp"

namespace isograsp::tasks {

namespace {

/// Mean force of the first 5 s.
statistics::Computed fresh_force(std::span<const double> t_s, std::span<const double> force_N) {
  assert(t_s.size() == force_N.size());
  constexpr double kFresh_s = 5.0;
  const std::size_t count =
      t_s.empty() ? 0 : statistics::first_row_from(t_s, t_s.front() + kFresh_s);
  if (count == t_s.size()) return "no more than 5 s of force"_text;
  const auto first_N = force_N.first(count);
  statistics::Computed mean = weighted_mean(first_N, statistics::hold_lengths(t_s.first(count)));
  double largest = 0.0;
  for (const double value : first_N) largest = std::max(largest, std::abs(value));
  constexpr double kZeroMean = 1e-12;  // rounding of a mean that is truly zero
  if (std::abs(*mean.value) <= kZeroMean * largest) return "the first 5 s have no force"_text;
  return mean;
}

}  // namespace

statistics::Computed fatigue_slope(std::span<const double> t_s, std::span<const double> force_N) {
  statistics::Computed fresh_N = fresh_force(t_s, force_N);
  if (!fresh_N.value) return fresh_N;
  const auto line = statistics::fit_line(t_s, force_N);
  if (!line) return "fewer than three samples"_text;
  return 100.0 * line->slope / *fresh_N.value;
}

statistics::EventTime time_to_fatigue(std::span<const double> t_s,
                                      std::span<const double> force_N) {
  constexpr double kShare = 0.8;
  constexpr double kLasting_s = 1.0;  // a lapse that is made good at once is not fatigue
  const statistics::Computed fresh_N = fresh_force(t_s, force_N);
  if (!fresh_N.value) return {fresh_N, {}};
  std::vector<bool> below(force_N.size());
  for (std::size_t k = 0; k < below.size(); ++k) below[k] = force_N[k] / *fresh_N.value < kShare;
  const auto found = statistics::stretches(t_s, below, kLasting_s);
  if (found.empty()) return {"the force stayed above 80 %"_text, t_s.back() - t_s.front()};
  return {t_s[found.front().first] - t_s.front(), {}};
}

}  // namespace isograsp::tasks
