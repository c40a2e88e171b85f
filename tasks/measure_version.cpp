// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measure_version.hpp"

#include <algorithm>
#include <array>

namespace isograsp::tasks {

namespace {

/// Those that are not in their first version. What changed stands in docs/measures.md.
constexpr auto kSecond = std::to_array<std::string_view>(
    {// The row after the end no longer counts, windows no longer win or lose a row by rounding.
     "maximum_force", "maximum_force_total", "comfortable_force", "comfortable_force_total",
     "peak_force", "peak_rate", "early_rate", "fatigue_slope", "endurance", "reaction_time", "t63",
     "settling_time", "rise_time", "overshoot", "opening_force", "individuation_index",
     "individuation_slope", "enslaving", "enslaving_of_maximum", "direction_error",
     "projection_ratio", "path_deviation", "constant_error", "absolute_error", "variable_error",
     "cv", "cv_noise_floor", "force_sd", "fall", "sparc", "rhythm", "grip_load_correlation",
     "grip_load_lag", "grip_load_slope",
     // Halves of a cycle keep their last row; the rate of a ramp is that of its target.
     "rmse", "time_in_range", "pauses", "pause_length",
     // A repetition in which no grip was made is neither a release nor a failed one.
     "release_initiation", "release_time", "anticipations", "residual_force", "fastest_release",
     // All sines of a target are fitted together.
     "gain",
     // Overlaps of two samples no longer hide the peak of a record shorter than the shifts.
     "lag",
     // Who stops at the time at which another target is reached, within rounding, was still trying.
     "median_completion_time", "restricted_mean_time"});
/// Version 2: single samples no longer count. Version 3: nor does the row after the end.
constexpr auto kThird = std::to_array<std::string_view>({"coflexion"});

template <class Names>
bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

int listed_version(std::string_view name) noexcept {
  if (has(kThird, name)) return 3;
  return has(kSecond, name) ? 2 : 1;
}

}  // namespace

int measure_version(std::string_view name) noexcept {
  // cancelled_share is a measure of its own, no companion of a time.
  if (const int own = listed_version(name); own != 1) return own;
  for (const std::string_view suffix : {"_share", "_restricted", "_corrected"})
    if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
  return listed_version(name);
}

bool is_older(const Measure& stored) noexcept {
  return stored.version < measure_version(stored.name);
}

bool any_is_older(std::span<const Measure> stored) noexcept {
  return std::any_of(stored.begin(), stored.end(), is_older);
}

int renew(std::vector<Measure>& stored, const std::vector<Measure>& scored) {
  int renewed = 0;
  for (Measure& one : stored) {
    if (!is_older(one)) continue;
    const auto same = std::find_if(scored.begin(), scored.end(), [&one](const Measure& again) {
      return again.name == one.name && again.channel == one.channel && again.unit == one.unit &&
             again.version > one.version;
    });
    if (same == scored.end()) continue;
    one = *same;
    one.recomputed = true;
    ++renewed;
  }
  return renewed;
}

}  // namespace isograsp::tasks
