// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/samples.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace isograsp::statistics {

std::size_t first_row_from(std::span<const double> t_s, double when_s) {
  return static_cast<std::size_t>(std::lower_bound(t_s.begin(), t_s.end(), when_s, is_earlier) -
                                  t_s.begin());
}

RowRange rows_between(std::span<const double> t_s, double from_s, double to_s) {
  const std::size_t first = first_row_from(t_s, from_s);
  return {first, std::max(first, first_row_from(t_s, to_s))};
}

bool is_regular(std::span<const double> t_s) {
  if (t_s.size() < 3) return true;
  const double largest = std::max(std::abs(t_s.front()), std::abs(t_s.back()));
  const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  const double step = t_s[1] - t_s[0];
  for (std::size_t k = 1; k + 1 < t_s.size(); ++k)
    if (std::abs((t_s[k + 1] - t_s[k]) - step) > 4.0 * ulp) return false;
  return true;
}

std::vector<double> hold_lengths(std::span<const double> t_s) {
  const std::size_t n = t_s.size();
  if (n < 2) return std::vector<double>(n, 0.0);
  if (is_regular(t_s)) return std::vector<double>(n, t_s[1] - t_s[0]);
  std::vector<double> holds(n);
  for (std::size_t k = 0; k + 1 < n; ++k) holds[k] = t_s[k + 1] - t_s[k];
  holds[n - 1] = holds[n - 2];
  return holds;
}

double median_step(std::span<const double> t_s) {
  if (t_s.size() < 2) return 0.0;
  std::vector<double> steps(t_s.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = t_s[k + 1] - t_s[k];
  const auto half = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), half, steps.end());
  if (steps.size() % 2 == 1) return *half;
  return 0.5 * (*std::max_element(steps.begin(), half) + *half);
}

std::vector<Stretch> stretches(std::span<const double> t_s, const std::vector<bool>& inside,
                               double least_s) {
  assert(t_s.size() == inside.size());
  constexpr double kHole_steps = 2.5;  // one lost sample is bridged, two are not
  const double step_s = median_step(t_s);
  std::vector<Stretch> found;
  for (std::size_t k = 0; k < t_s.size();) {
    if (!inside[k]) {
      ++k;
      continue;
    }
    Stretch run{k, k + 1, 0.0};
    while (run.end < t_s.size() && inside[run.end] &&
           t_s[run.end] - t_s[run.end - 1] <= kHole_steps * step_s)
      ++run.end;
    run.length_s = t_s[run.end - 1] - t_s[run.first] + step_s;
    if (!is_earlier(run.length_s, least_s)) found.push_back(run);
    k = run.end;
  }
  return found;
}

double crossing_time(std::span<const double> t_s, std::span<const double> x, std::size_t k,
                     double level) {
  assert(k > 0 && x[k] != x[k - 1]);
  return t_s[k - 1] + (level - x[k - 1]) / (x[k] - x[k - 1]) * (t_s[k] - t_s[k - 1]);
}

UniformSamples on_uniform_grid(std::span<const double> t_s, std::span<const double> values) {
  assert(t_s.size() == values.size() && t_s.size() >= 2);
  if (is_regular(t_s)) return {t_s[1] - t_s[0], {values.begin(), values.end()}};
  UniformSamples samples;
  samples.step_s = median_step(t_s);
  constexpr double kRoundingSlack = 1e-9;  // keeps a last point that rounding puts past the end
  const double steps = (t_s.back() - t_s.front()) / samples.step_s;
  const auto count = static_cast<std::size_t>(std::floor(steps + kRoundingSlack)) + 1;
  samples.values.reserve(count);
  std::size_t k = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = std::min(t_s.front() + static_cast<double>(i) * samples.step_s, t_s.back());
    while (k + 2 < t_s.size() && t_s[k + 1] <= t) ++k;
    const double share = (t - t_s[k]) / (t_s[k + 1] - t_s[k]);
    samples.values.push_back(values[k] + share * (values[k + 1] - values[k]));
  }
  return samples;
}

std::vector<double> grid_times(const UniformSamples& samples) {
  std::vector<double> t_s(samples.values.size());
  for (std::size_t k = 0; k < t_s.size(); ++k) t_s[k] = static_cast<double>(k) * samples.step_s;
  return t_s;
}

}  // namespace isograsp::statistics
