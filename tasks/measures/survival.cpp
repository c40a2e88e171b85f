// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/survival.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace isograsp {

namespace {

constexpr double kRoundingSlack = 1e-9;  // shares are products of fractions, times sums of steps
constexpr const char* kNobodyTried = "nothing was tried";

}  // namespace

Reached reached_of(std::span<const Completion> completions) {
  const auto count = std::count_if(completions.begin(), completions.end(),
                                   [](const Completion& c) { return c.reached; });
  return {static_cast<int>(count), static_cast<int>(completions.size())};
}

std::vector<SurvivalStep> survival(std::span<const Completion> completions) {
  std::vector<Completion> sorted(completions.begin(), completions.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const Completion& a, const Completion& b) { return a.time_s < b.time_s; });
  std::vector<SurvivalStep> steps;
  double share = 1.0;
  for (std::size_t k = 0; k < sorted.size();) {
    const double trying = static_cast<double>(sorted.size() - k);
    const double time_s = sorted[k].time_s;
    double done = 0.0;
    for (; k < sorted.size() && sorted[k].time_s == time_s; ++k)
      if (sorted[k].reached) done += 1.0;
    if (!(done > 0.0)) continue;
    share *= (trying - done) / trying;
    steps.push_back({time_s, share});
  }
  return steps;
}

Computed median_completion(std::span<const Completion> completions) {
  if (completions.empty()) return kNobodyTried;
  constexpr double kHalf = 0.5;
  for (const SurvivalStep& step : survival(completions))
    if (step.share <= kHalf + kRoundingSlack) return step.time_s;
  return "longer than the limit";
}

Computed restricted_mean_time(std::span<const Completion> completions, double limit_s) {
  assert(limit_s > 0.0);
  if (completions.empty()) return kNobodyTried;
  const std::vector<SurvivalStep> steps = survival(completions);
  double longest_s = 0.0;
  for (const Completion& c : completions) longest_s = std::max(longest_s, c.time_s);
  const bool all_done = !steps.empty() && steps.back().share <= 0.0;
  if (!all_done && longest_s < limit_s * (1.0 - kRoundingSlack))
    return "the last attempts ended before the limit";
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
  const auto key = [&](std::size_t k) {
    return completions[k].reached ? completions[k].time_s : std::numeric_limits<double>::infinity();
  };
  std::vector<std::size_t> order(completions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<double> rank(completions.size());
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first;
    while (end < order.size() && key(order[end]) == key(order[first])) ++end;
    // Mean of the ranks first + 1 … end.
    for (std::size_t k = first; k < end; ++k)
      rank[order[k]] = 0.5 * static_cast<double>(first + 1 + end);
    first = end;
  }
  return rank;
}

}  // namespace isograsp
