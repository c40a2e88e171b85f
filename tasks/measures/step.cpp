// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of the step, from the level before (0) to the level after (1), over time:
//   rise 10 to 90 % = t(0.9) - t(0.1),  overshoot = largest share - 1
#include "tasks/measures/step.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isograsp::tasks {

StepResponse step_response(std::span<const double> t_s, std::span<const double> y,
                           double final_value) {
  assert(t_s.size() == y.size() && !y.empty() && final_value != 0.0);
  const auto first_crossing = [&](double share) -> std::optional<double> {
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double here = y[k] / final_value;
      if (here < share) continue;
      if (k == 0) return t_s[0];
      const double before = y[k - 1] / final_value;
      return t_s[k - 1] + (share - before) / (here - before) * (t_s[k] - t_s[k - 1]);
    }
    return std::nullopt;
  };
  StepResponse response;
  response.t10_s = first_crossing(0.1);
  response.t63_s = first_crossing(1.0 - 1.0 / std::numbers::e);
  response.t90_s = first_crossing(0.9);
  if (response.t10_s && response.t90_s) response.rise10_90_s = *response.t90_s - *response.t10_s;
  constexpr double kSettled = 0.02;
  std::size_t settled_from = y.size();
  while (settled_from > 0 && std::abs(y[settled_from - 1] / final_value - 1.0) <= kSettled)
    --settled_from;
  if (settled_from < y.size()) response.settle2pct_s = t_s[settled_from];
  for (const double value : y)
    response.overshoot = std::max(response.overshoot, value / final_value - 1.0);
  return response;
}

namespace {

/// The rows from the cue on, as shares of the step.
struct Shares {
  std::span<const double> t_s;
  std::vector<double> z;
  double cue_s = 0.0;

  [[nodiscard]] double waited_s() const { return t_s.back() - cue_s; }
};

statistics::EventTime time_to(const Shares& shares, double share) {
  const auto reached =
      std::find_if(shares.z.begin(), shares.z.end(), [&](double value) { return value >= share; });
  if (reached == shares.z.end()) return {"the level was not reached"_text, shares.waited_s()};
  if (reached == shares.z.begin()) return {"already there at the cue"_text, {}};
  const auto k = static_cast<std::size_t>(reached - shares.z.begin());
  return {statistics::crossing_time(shares.t_s, shares.z, k, share) - shares.cue_s, {}};
}

statistics::EventTime settling_time(const Shares& shares) {
  constexpr double kBand = 0.05;
  constexpr double kSettled_s = 0.2;
  std::vector<bool> inside(shares.z.size());
  for (std::size_t k = 0; k < inside.size(); ++k) inside[k] = std::abs(shares.z[k] - 1.0) <= kBand;
  const auto found = statistics::stretches(shares.t_s, inside, kSettled_s);
  if (found.empty()) return {"not settled for 0.2 s"_text, shares.waited_s()};
  return {shares.t_s[found.front().first] - shares.cue_s, {}};
}

}  // namespace

CuedStepResponse cued_step_response(std::span<const double> t_s, std::span<const double> x,
                                    const CuedStep& step, double lsb) {
  assert(t_s.size() == x.size() && step.from != step.to);
  const std::size_t first = statistics::first_row_from(t_s, step.cue_s);
  if (first == t_s.size()) {
    constexpr Words none = "no samples after the cue"_text;
    return {{{none, {}}, {}}, {none, {}}, {none, {}}, {none, {}}, none, none, none, {none, {}}};
  }
  Shares shares{t_s.subspan(first), {}, step.cue_s};
  shares.z.reserve(shares.t_s.size());
  for (const double value : x.subspan(first))
    shares.z.push_back((value - step.from) / (step.to - step.from));

  const auto held = level_before(t_s, x, step.cue_s);
  const Change change = step.to > step.from ? Change::rise : Change::fall;
  const statistics::EventTime t10 = time_to(shares, 0.1);
  const statistics::EventTime t90 = time_to(shares, 0.9);
  const auto top = std::max_element(shares.z.begin(), shares.z.end());
  const bool beyond = *top > 1.0;
  return {held ? reaction(t_s, x, step.cue_s, *held, lsb, change)
               : Reaction{{"no level before the cue"_text, {}}, {}},
          t10,
          time_to(shares, 1.0 - 1.0 / std::numbers::e),
          t90,
          t10.time_s.value && t90.time_s.value
              ? statistics::Computed(*t90.time_s.value - *t10.time_s.value)
              : statistics::Computed(t10.time_s.value ? t90.time_s.reason : t10.time_s.reason),
          beyond ? 100.0 * (*top - 1.0) : 0.0,
          beyond ? statistics::Computed(
                       shares.t_s[static_cast<std::size_t>(top - shares.z.begin())] - step.cue_s)
                 : statistics::Computed("no overshoot"_text),
          settling_time(shares)};
}

}  // namespace isograsp::tasks
