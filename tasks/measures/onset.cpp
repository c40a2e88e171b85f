// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/onset.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp::tasks {

double RestingLevel::margin(double lsb) const {
  return std::max(3.0 * sd, 2.0 * lsb);
}

std::optional<RestingLevel> resting_level(std::span<const double> x) {
  if (x.size() < 2) return std::nullopt;
  const auto n = static_cast<double>(x.size());
  double mean = 0.0;
  for (const double value : x) mean += value;
  mean /= n;
  double squares = 0.0;
  for (const double value : x) squares += (value - mean) * (value - mean);
  return RestingLevel{mean, std::sqrt(squares / (n - 1.0))};
}

std::optional<RestingLevel> level_before(std::span<const double> t_s, std::span<const double> x,
                                         double cue_s) {
  assert(t_s.size() == x.size());
  constexpr double kLevel_s = 1.0;  // long enough for a slow tremor to show in the SD
  const statistics::RowRange before = statistics::rows_between(t_s, cue_s - kLevel_s, cue_s);
  return resting_level(x.subspan(before.first, before.count()));
}

namespace {

constexpr double kOnset_s = 0.05;

std::vector<bool> beyond(std::span<const double> x, double threshold, Change change) {
  std::vector<bool> is_beyond(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    is_beyond[k] = change == Change::rise ? x[k] > threshold : x[k] < threshold;
  return is_beyond;
}

}  // namespace

std::optional<std::size_t> onset(std::span<const double> t_s, std::span<const double> x,
                                 double threshold, Change change) {
  assert(t_s.size() == x.size());
  const auto found = statistics::stretches(t_s, beyond(x, threshold, change), kOnset_s);
  if (found.empty()) return std::nullopt;
  return found.front().first;
}

Reaction reaction(std::span<const double> t_s, std::span<const double> x, double cue_s,
                  const RestingLevel& before, double lsb, Change change) {
  assert(t_s.size() == x.size());
  constexpr double kAnticipation_s = 0.1;
  if (t_s.empty() || statistics::is_earlier(t_s.back(), cue_s))
    return {{"no samples after the cue"_text, {}}, {}};
  const double margin = before.margin(lsb);
  const double threshold = before.mean + (change == Change::rise ? margin : -margin);
  for (const statistics::Stretch& stretch :
       statistics::stretches(t_s, beyond(x, threshold, change), kOnset_s)) {
    if (statistics::is_earlier(t_s[stretch.end - 1], cue_s))
      continue;  // over before the cue: no answer to it
    const double time_s = t_s[stretch.first] - cue_s;
    if (statistics::is_earlier(time_s, kAnticipation_s))
      return {{"anticipated: less than 100 ms after the cue"_text, {}}, time_s};
    return {{time_s, {}}, {}};
  }
  return {{"no reaction to the cue"_text, t_s.back() - cue_s}, {}};
}

}  // namespace isograsp::tasks
