// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/release.hpp"

#include <algorithm>
#include <cassert>

#include "tasks/measures/rate.hpp"

namespace isograsp::tasks {

namespace {

statistics::EventTime time_to_level(std::span<const double> t_s, std::span<const double> force_N,
                                    double cue_s, double level_N) {
  constexpr double kReleased_s = 0.05;
  std::vector<bool> below(force_N.size());
  for (std::size_t k = 0; k < below.size(); ++k) below[k] = force_N[k] <= level_N;
  const auto found = statistics::stretches(t_s, below, kReleased_s);
  if (found.empty()) return {"not released"_text, t_s.back() - cue_s};
  const std::size_t k = found.front().first;
  if (k == 0) return {"let go before the cue"_text, {}};
  const double above_N = force_N[k - 1];  // both rows may be below if a gap parts them
  const double time_s =
      above_N > level_N ? statistics::crossing_time(t_s, force_N, k, level_N) : t_s[k];
  return {time_s - cue_s, {}};
}

/// Mean over [from_s, to_s), rows weighted by how far they reach in.
statistics::Computed mean_between(std::span<const double> t_s, std::span<const double> x,
                                  double from_s, double to_s) {
  constexpr double kLeastCovered = 0.5;  // of the window
  const auto first = std::upper_bound(t_s.begin(), t_s.end(), from_s);
  const double step_s = statistics::median_step(t_s);
  double sum = 0.0;
  double covered_s = 0.0;
  auto k = static_cast<std::size_t>(first - t_s.begin());
  if (k > 0) --k;  // holds into the window
  for (; k < t_s.size() && t_s[k] < to_s; ++k) {
    const double end_s =
        t_s[k] + (k + 1 < t_s.size() ? std::min(t_s[k + 1] - t_s[k], 2.0 * step_s) : step_s);
    const double length_s = std::min(end_s, to_s) - std::max(t_s[k], from_s);
    if (length_s <= 0.0) continue;
    sum += length_s * x[k];
    covered_s += length_s;
  }
  if (statistics::is_earlier(covered_s, kLeastCovered * (to_s - from_s)))
    return "not recorded 5 s after the cue"_text;
  return sum / covered_s;
}

}  // namespace

double AskedGrip::least_N() const {
  constexpr double kNearEnough = 0.5;  // of what was asked: less is another force, or none
  const double told_apart_N = RestingLevel{0.0, noise_sd_N}.margin(resolution_N);
  return std::max(kNearEnough * (asked_N - resting_N), told_apart_N);
}

Release release(std::span<const double> t_s, std::span<const double> force_N, double cue_s,
                const AskedGrip& grip) {
  assert(t_s.size() == force_N.size());
  constexpr double kResidual_s = 5.0;
  constexpr double kHalfWindow_s = 0.1;
  constexpr double kHeld_s = 1.0;
  constexpr double kReleasedShare = 0.1;
  const auto without = [](std::optional<bool> grip_made, Words why) {
    return Release{grip_made, {{why, {}}, {}}, {why, {}}, why, why};
  };
  const std::size_t first = statistics::first_row_from(t_s, cue_s);
  const auto held = level_before(t_s, force_N, cue_s);
  if (!held) return without(std::nullopt, "no force held before the cue"_text);
  if (first == t_s.size()) return without(std::nullopt, "no samples after the cue"_text);
  const double above_rest_N = held->mean - grip.resting_N;
  if (!(above_rest_N > 0.0 && above_rest_N >= grip.least_N()))
    return without(false, "no grip was made"_text);
  const statistics::RowRange hold = statistics::rows_between(t_s, cue_s - kHeld_s, cue_s);
  const auto held_N = force_N.subspan(hold.first, hold.count());
  const double peak_N = *std::max_element(held_N.begin(), held_N.end());
  const double released_N = grip.resting_N + kReleasedShare * (peak_N - grip.resting_N);
  const auto after_s = t_s.subspan(first);
  const auto after_N = force_N.subspan(first);
  statistics::Computed residual_N = mean_between(t_s, force_N, cue_s + kResidual_s - kHalfWindow_s,
                                                 cue_s + kResidual_s + kHalfWindow_s);
  if (residual_N.value) residual_N.value = *residual_N.value - grip.resting_N;
  return {true, reaction(t_s, force_N, cue_s, *held, grip.resolution_N, Change::fall),
          time_to_level(after_s, after_N, cue_s, released_N), residual_N,
          peak_relaxation(after_s, after_N)};
}

}  // namespace isograsp::tasks
