// SPDX-License-Identifier: GPL-3.0-or-later
// e = actual - target, w: how long each sample lasts:
//   RMSE = sqrt(sum w e^2 / sum w),  MAE = sum w |e| / sum w,  constant error = sum w e / sum w
//   relative RMSE = 100 RMSE / largest |target|
//   time in band = 100 (sum of w where |e| <= max(share |target|, 3 noise_sd)) / sum w
//   CV = 100 (SD about the fitted line) / mean
#include "tasks/measures/error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "statistics/line.hpp"
#include "statistics/weighted.hpp"

namespace isograsp::tasks {

namespace {

statistics::Computed percent(statistics::Computed share) {
  if (share.value) share.value = 100.0 * *share.value;
  return share;
}

}  // namespace

statistics::Computed weighted_mean(std::span<const double> x, std::span<const double> weight) {
  assert(x.size() == weight.size());
  return statistics::weighted_mean_of(weight, [&](std::size_t k) { return x[k]; });
}

statistics::Computed rmse(std::span<const double> target, std::span<const double> actual,
                          std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  statistics::Computed mean_square = statistics::weighted_mean_of(weight, [&](std::size_t k) {
    const double e = actual[k] - target[k];
    return e * e;
  });
  if (mean_square.value) mean_square.value = std::sqrt(*mean_square.value);
  return mean_square;
}

statistics::Computed mae(std::span<const double> target, std::span<const double> actual,
                         std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  return statistics::weighted_mean_of(
      weight, [&](std::size_t k) { return std::abs(actual[k] - target[k]); });
}

statistics::Computed constant_error(std::span<const double> target, std::span<const double> actual,
                                    std::span<const double> weight) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  return statistics::weighted_mean_of(weight, [&](std::size_t k) { return actual[k] - target[k]; });
}

statistics::Computed relative_rmse(std::span<const double> target, std::span<const double> actual,
                                   std::span<const double> weight) {
  statistics::Computed error = rmse(target, actual, weight);
  if (!error.value) return error;
  double largest = 0.0;
  for (const double value : target) largest = std::max(largest, std::abs(value));
  if (!(largest > 0.0)) return "the target is zero throughout"_text;
  return 100.0 * *error.value / largest;
}

statistics::Computed time_in_range(std::span<const double> target, std::span<const double> actual,
                                   std::span<const double> weight, double noise_sd) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  constexpr double kShareOfTarget = 0.05;
  return time_in_band(target, actual, weight, kShareOfTarget, noise_sd);
}

statistics::Computed time_in_band(std::span<const double> target, std::span<const double> actual,
                                  std::span<const double> weight, double share_of_target,
                                  double noise_sd) {
  assert(target.size() == actual.size() && target.size() == weight.size());
  return percent(statistics::weighted_mean_of(weight, [&](std::size_t k) {
    const double band = std::max(share_of_target * std::abs(target[k]), 3.0 * noise_sd);
    return std::abs(actual[k] - target[k]) <= band ? 1.0 : 0.0;
  }));
}

Corridor corridor(std::span<const double> lower, std::span<const double> upper,
                  std::span<const double> actual, std::span<const double> weight) {
  assert(lower.size() == actual.size() && upper.size() == actual.size());
  assert(weight.size() == actual.size());
  const auto outside = [&](std::size_t k) {
    return std::max({lower[k] - actual[k], actual[k] - upper[k], 0.0});
  };
  statistics::Computed mean_square =
      statistics::weighted_mean_of(weight, [&](std::size_t k) { return outside(k) * outside(k); });
  if (mean_square.value) mean_square.value = std::sqrt(*mean_square.value);
  return {percent(statistics::weighted_mean_of(
              weight, [&](std::size_t k) { return outside(k) > 0.0 ? 0.0 : 1.0; })),
          statistics::weighted_mean_of(weight, outside), mean_square};
}

statistics::Computed cv(std::span<const double> t_s, std::span<const double> x) {
  assert(t_s.size() == x.size());
  const auto line = statistics::fit_line(t_s, x);
  if (!line) return "fewer than three samples"_text;
  double largest = 0.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  constexpr double kZeroMean = 1e-12;  // rounding of a mean that is truly zero
  if (std::abs(line->mean) <= kZeroMean * largest) return "the mean is zero"_text;
  return 100.0 * line->residual_sd / line->mean;
}

statistics::Computed best_moving_mean(std::span<const double> x, std::span<const double> weight,
                                      const std::vector<bool>& valid, double window_s) {
  assert(x.size() == weight.size() && x.size() == valid.size());
  constexpr double kRoundingSlack = 1e-9;  // a window of whole frames needs no part of one more
  statistics::Computed best = "no uninterrupted window of valid samples is long enough"_text;
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

}  // namespace isograsp::tasks
