// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/robust_trend.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.hpp"

namespace isograsp {

namespace {

constexpr int kResamples = 400;  // the ends of a 95 % interval are then the tenth values
constexpr std::uint64_t kSeed = 1968;

double median_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// `estimate` of resampled indices 0 … n - 1; nothing where it has no value.
template <class F>
std::optional<Estimate> with_interval(std::size_t n, F estimate) {
  std::vector<std::size_t> chosen(n);
  for (std::size_t i = 0; i < n; ++i) chosen[i] = i;
  const std::optional<double> value = estimate(chosen);
  if (!value) return std::nullopt;
  Random random(kSeed);
  std::vector<double> all;
  for (int k = 0; k < kResamples; ++k) {
    for (auto& index : chosen)
      index = std::min(n - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(n)));
    if (const std::optional<double> one = estimate(chosen)) all.push_back(*one);
  }
  if (all.empty()) return std::nullopt;
  std::sort(all.begin(), all.end());
  constexpr double kTail = 0.025;
  const auto tail = static_cast<std::size_t>(kTail * static_cast<double>(all.size()));
  return Estimate{*value, all[tail], all[all.size() - 1 - tail]};
}

}  // namespace

std::optional<Estimate> theil_sen(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < kLeastTrendDays) return std::nullopt;
  std::vector<double> slopes;
  return with_interval(n, [&](const std::vector<std::size_t>& chosen) -> std::optional<double> {
    slopes.clear();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j) {
        const double run = x[chosen[j]] - x[chosen[i]];
        if (run != 0.0) slopes.push_back((y[chosen[j]] - y[chosen[i]]) / run);
      }
    if (slopes.empty()) return std::nullopt;
    return median_of(slopes);
  });
}

std::optional<RankTrend> rank_trend(std::span<const CensoredDay> days) {
  const std::size_t n = days.size();
  if (n < kLeastTrendDays) return std::nullopt;
  RankTrend trend;
  std::vector<double> time;
  for (const auto& day : days) {
    trend.reached += day.reached;
    trend.tried += day.tried;
    time.push_back(day.value.value_or(std::numeric_limits<double>::infinity()));
  }
  const auto sign = [](double a, double b) { return a < b ? 1.0 : b < a ? -1.0 : 0.0; };
  const auto tau =
      with_interval(n, [&](const std::vector<std::size_t>& chosen) -> std::optional<double> {
        double sum = 0.0;
        double untied_x = 0.0;
        double untied_y = 0.0;
        for (std::size_t i = 0; i < n; ++i)
          for (std::size_t j = i + 1; j < n; ++j) {
            const double dx = sign(days[chosen[i]].x, days[chosen[j]].x);
            const double dy = sign(time[chosen[i]], time[chosen[j]]);
            sum += dx * dy;
            untied_x += dx * dx;
            untied_y += dy * dy;
          }
        if (untied_x == 0.0 || untied_y == 0.0) return std::nullopt;
        return sum / std::sqrt(untied_x * untied_y);
      });
  if (!tau) return std::nullopt;
  trend.tau = *tau;
  return trend;
}

}  // namespace isograsp
