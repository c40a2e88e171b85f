// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/delay.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp {

namespace {

/// Pearson r between target[k] and actual[k + shift] over the samples that both have.
std::optional<double> correlation(std::span<const double> target, std::span<const double> actual,
                                  std::ptrdiff_t shift) {
  const auto n = static_cast<std::ptrdiff_t>(target.size());
  const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, -shift);
  const std::ptrdiff_t count = std::min(n, n - shift) - first;
  constexpr std::ptrdiff_t kLeastOverlap = 3;  // two points always correlate perfectly
  if (count < kLeastOverlap) return std::nullopt;
  const double* const x = target.data() + first;
  const double* const y = actual.data() + first + shift;
  double x_mean = 0.0;
  double y_mean = 0.0;
  double x_most = 0.0;
  double y_most = 0.0;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    x_mean += x[k];
    y_mean += y[k];
    x_most = std::max(x_most, std::abs(x[k]));
    y_most = std::max(y_most, std::abs(y[k]));
  }
  x_mean /= static_cast<double>(count);
  y_mean /= static_cast<double>(count);
  double xx = 0.0;
  double yy = 0.0;
  double xy = 0.0;
  for (std::ptrdiff_t k = 0; k < count; ++k) {
    xx += (x[k] - x_mean) * (x[k] - x_mean);
    yy += (y[k] - y_mean) * (y[k] - y_mean);
    xy += (x[k] - x_mean) * (y[k] - y_mean);
  }
  // A constant signal leaves only the rounding of its mean: about n eps^2 max^2.
  constexpr double kConstant = 1e-26;
  const double n_count = static_cast<double>(count);
  if (xx <= kConstant * n_count * x_most * x_most || yy <= kConstant * n_count * y_most * y_most)
    return std::nullopt;
  return xy / std::sqrt(xx * yy);
}

}  // namespace

Computed lag(const UniformSamples& target, const UniformSamples& actual) {
  assert(target.values.size() == actual.values.size());
  constexpr double kMost_s = 1.5;
  constexpr double kLeastCorrelation = 0.35;
  constexpr double kRoundingSlack = 1e-9;
  const auto most =
      static_cast<std::ptrdiff_t>(std::floor(kMost_s / target.step_s * (1.0 + kRoundingSlack)));
  std::vector<std::optional<double>> r(static_cast<std::size_t>(2 * most + 1));
  std::optional<std::size_t> peak;
  for (std::size_t i = 0; i < r.size(); ++i) {
    r[i] = correlation(target.values, actual.values, static_cast<std::ptrdiff_t>(i) - most);
    if (r[i] && (!peak || *r[i] > *r[*peak])) peak = i;
  }
  if (!peak) return "target or actual does not vary";
  if (*r[*peak] < kLeastCorrelation) return "the correlation stays below 0.35";
  if (*peak == 0 || *peak + 1 == r.size() || !r[*peak - 1] || !r[*peak + 1])
    return "the correlation has no peak within 1.5 s";
  const double before = *r[*peak - 1];
  const double here = *r[*peak];
  const double after = *r[*peak + 1];
  const double bend = before - 2.0 * here + after;
  const double part = bend < 0.0 ? 0.5 * (before - after) / bend : 0.0;
  const auto shift = static_cast<std::ptrdiff_t>(*peak) - most;
  return (static_cast<double>(shift) + part) * target.step_s;
}

}  // namespace isograsp
