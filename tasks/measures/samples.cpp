// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/samples.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace isograsp {

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

namespace {

double median_step(std::span<const double> t_s) {
  std::vector<double> steps(t_s.size() - 1);
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = t_s[k + 1] - t_s[k];
  std::sort(steps.begin(), steps.end());
  const std::size_t half = steps.size() / 2;
  return steps.size() % 2 == 1 ? steps[half] : 0.5 * (steps[half - 1] + steps[half]);
}

}  // namespace

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

}  // namespace isograsp
