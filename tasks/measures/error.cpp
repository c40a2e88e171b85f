// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace isograsp {

namespace {

constexpr const char* kNoSamples = "no samples";

/// Weighted mean of f(k).
template <class Function>
Computed mean_of(std::span<const double> weight, Function&& f) {
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < weight.size(); ++k) {
    sum += weight[k] * f(k);
    total += weight[k];
  }
  if (!(total > 0.0)) return kNoSamples;
  return sum / total;
}

}  // namespace

Computed weighted_mean(std::span<const double> x, std::span<const double> weight) {
  assert(x.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) { return x[k]; });
}

Computed rmse(std::span<const double> target, std::span<const double> actual,
              std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  Computed mean_square = mean_of(weight, [&](std::size_t k) {
    const double e = actual[k] - target[k];
    return e * e;
  });
  if (mean_square.value) mean_square.value = std::sqrt(*mean_square.value);
  return mean_square;
}

Computed mae(std::span<const double> target, std::span<const double> actual,
             std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) { return std::abs(actual[k] - target[k]); });
}

Computed constant_error(std::span<const double> target, std::span<const double> actual,
                        std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  return mean_of(weight, [&](std::size_t k) { return actual[k] - target[k]; });
}

Computed relative_rmse(std::span<const double> target, std::span<const double> actual,
                       std::span<const double> weight) {
  Computed error = rmse(target, actual, weight);
  if (!error.value) return error;
  double largest = 0.0;
  for (const double value : target) largest = std::max(largest, std::abs(value));
  if (!(largest > 0.0)) return "the target is zero throughout";
  return 100.0 * *error.value / largest;
}

Computed time_in_range(std::span<const double> target, std::span<const double> actual,
                       std::span<const double> weight, double noise_sd) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  constexpr double kShareOfTarget = 0.05;
  Computed share = mean_of(weight, [&](std::size_t k) {
    const double band = std::max(kShareOfTarget * std::abs(target[k]), 3.0 * noise_sd);
    return std::abs(actual[k] - target[k]) <= band ? 1.0 : 0.0;
  });
  if (share.value) share.value = 100.0 * *share.value;
  return share;
}

Computed cv(std::span<const double> t_s, std::span<const double> x) {
  assert(t_s.size() == x.size());
  const std::size_t n = x.size();
  if (n < 3) return "fewer than three samples";
  double t_mean = 0.0;
  double x_mean = 0.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    t_mean += t_s[k];
    x_mean += x[k];
    largest = std::max(largest, std::abs(x[k]));
  }
  t_mean /= static_cast<double>(n);
  x_mean /= static_cast<double>(n);
  constexpr double kZeroMean = 1e-12;  // rounding of a mean that is truly zero
  if (std::abs(x_mean) <= kZeroMean * largest) return "the mean is zero";
  double tt = 0.0;
  double tx = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    tt += (t_s[k] - t_mean) * (t_s[k] - t_mean);
    tx += (t_s[k] - t_mean) * (x[k] - x_mean);
  }
  const double slope = tx / tt;
  double squares = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double residual = x[k] - x_mean - slope * (t_s[k] - t_mean);
    squares += residual * residual;
  }
  return 100.0 * std::sqrt(squares / static_cast<double>(n - 1)) / x_mean;
}

Computed best_moving_mean(std::span<const double> x, std::span<const double> weight,
                          const std::vector<bool>& valid, double window_s) {
  assert(x.size() == weight.size() && x.size() == valid.size());
  constexpr double kRoundingSlack = 1e-9;  // a window of whole frames needs no part of one more
  Computed best = "no uninterrupted window of valid samples is long enough";
  for (std::size_t first = 0; first < x.size(); ++first) {
    double sum = 0.0;
    double missing_s = window_s;
    for (std::size_t k = first; k < x.size() && valid[k]; ++k) {
      const double share = std::min(weight[k], missing_s);
      sum += share * x[k];
      missing_s -= share;
      if (missing_s <= kRoundingSlack * window_s) break;
    }
    if (missing_s > kRoundingSlack * window_s) continue;
    const double mean = sum / (window_s - missing_s);
    if (!best.value || mean > *best.value) best = mean;
  }
  return best;
}

}  // namespace isograsp
