// SPDX-License-Identifier: GPL-3.0-or-later
// Kaplan and Meier. At each time t_i at which somebody arrived, trying_i had not arrived or stopped
// before, and done_i arrived then:
//   share(t) = product of (trying_i - done_i) / trying_i over all t_i <= t
//   median = the first t_i with share <= 1 / 2
//   restricted mean = integral of share(t) from 0 to limit_s
#include "statistics/survival.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/ties.hpp"

namespace isograsp::statistics {

namespace {

constexpr double kRoundingSlack = 1e-9;  // shares are products of fractions, times sums of steps
constexpr Words kNobodyTried = "nothing was tried"_text;

}  // namespace

Reached reached_of(std::span<const Completion> completions) {
  const auto count = std::count_if(completions.begin(), completions.end(),
                                   [](const Completion& c) { return c.reached; });
  return {static_cast<int>(count), static_cast<int>(completions.size())};
}

std::vector<SurvivalStep> survival(std::span<const Completion> completions) {
  std::vector<double> reached_s;
  for (const Completion& c : completions)
    if (c.reached) reached_s.push_back(c.time_s);
  std::sort(reached_s.begin(), reached_s.end());
  std::vector<SurvivalStep> steps;
  double share = 1.0;
  for (auto first = reached_s.begin(); first != reached_s.end();) {
    const double time_s = *first;
    const auto end = std::upper_bound(first, reached_s.end(), time_s);
    const auto done = static_cast<double>(end - first);
    // Somebody who stops when another arrives was still trying then, even if the last bits of the
    // two times differ. Arrivals need no such care: two steps at almost one time give the same
    // share as one.
    const auto trying = static_cast<double>(
        std::count_if(completions.begin(), completions.end(), [time_s](const Completion& c) {
          return c.reached ? c.time_s >= time_s : !is_earlier(c.time_s, time_s);
        }));
    share *= (trying - done) / trying;
    steps.push_back({time_s, share});
    first = end;
  }
  return steps;
}

Computed median_completion(std::span<const Completion> completions) {
  if (completions.empty()) return kNobodyTried;
  constexpr double kHalf = 0.5;
  for (const SurvivalStep& step : survival(completions))
    if (step.share <= kHalf + kRoundingSlack) return step.time_s;
  return "longer than the limit"_text;
}

Computed restricted_mean_time(std::span<const Completion> completions, double limit_s) {
  assert(limit_s > 0.0);
  if (completions.empty()) return kNobodyTried;
  const std::vector<SurvivalStep> steps = survival(completions);
  double longest_s = 0.0;
  for (const Completion& c : completions) longest_s = std::max(longest_s, c.time_s);
  const bool all_done = !steps.empty() && steps.back().share <= 0.0;
  if (!all_done && longest_s < limit_s * (1.0 - kRoundingSlack))
    return "the last attempts ended before the limit"_text;
  double mean_s = 0.0;
  double from_s = 0.0;
  double share = 1.0;
  for (const SurvivalStep& step : steps) {
    const double to_s = std::min(step.time_s, limit_s);
    mean_s += share * (to_s - from_s);
    from_s = to_s;
    share = step.share;
  }
  return mean_s + share * (limit_s - from_s);
}

std::vector<double> ranks(std::span<const Completion> completions) {
  std::vector<double> times_s;
  for (const Completion& c : completions)
    times_s.push_back(c.reached ? c.time_s : std::numeric_limits<double>::infinity());
  return mid_ranks(times_s, kTimeSlack_s);
}

}  // namespace isograsp::statistics
