// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measures/trend.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/erf.hpp>

#include "tasks/measures/percentile.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kMostExact = 50;  // beyond, the normal distribution is as good

/// Probability of each number of inversions in a random order of n.
std::vector<double> inversions(std::size_t n) {
  std::vector<double> probability{1.0};
  for (std::size_t m = 2; m <= n; ++m) {  // the m-th element can stand before 0 ... m - 1 others
    std::vector<double> next(probability.size() + m - 1, 0.0);
    for (std::size_t k = 0; k < probability.size(); ++k)
      for (std::size_t j = 0; j < m; ++j) next[k + j] += probability[k] / static_cast<double>(m);
    probability = std::move(next);
  }
  return probability;
}

/// Largest m for which fewer than m inversions are no more likely than `tail`.
std::size_t exact_rank(std::size_t points, double tail) {
  std::size_t rank = 0;
  double sum = 0.0;
  for (const double probability : inversions(points)) {
    sum += probability;
    if (sum > tail) break;
    ++rank;
  }
  return rank;
}

/// Variance of S with ties in x, eq. (2.6) of Sen.
double variance_of_s(std::span<const double> x) {
  const auto term = [](double n) { return n * (n - 1.0) * (2.0 * n + 5.0) / 18.0; };
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  double variance = term(static_cast<double>(sorted.size()));
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto last = std::upper_bound(first, sorted.end(), *first);
    variance -= term(static_cast<double>(last - first));
    first = last;
  }
  return variance;
}

std::size_t normal_rank(std::span<const double> x, std::size_t slopes, double confidence) {
  const double z = std::numbers::sqrt2 * boost::math::erf_inv(confidence);
  const double rank =
      std::floor(0.5 * (static_cast<double>(slopes) - z * std::sqrt(variance_of_s(x))));
  return rank < 1.0 ? 0 : static_cast<std::size_t>(rank);
}

}  // namespace

std::optional<Trend> theil_sen(std::span<const double> x, std::span<const double> y,
                               double confidence) {
  assert(x.size() == y.size() && confidence > 0.0 && confidence < 1.0);
  std::vector<double> slopes;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if (x[i] != x[j]) slopes.push_back((y[j] - y[i]) / (x[j] - x[i]));
  if (slopes.empty()) return std::nullopt;
  std::sort(slopes.begin(), slopes.end());
  Trend trend;
  trend.slope = *median(slopes).value;
  trend.intercept = *median(y).value - trend.slope * *median(x).value;
  const bool ties = slopes.size() < x.size() * (x.size() - 1) / 2;
  const std::size_t rank = !ties && x.size() <= kMostExact
                               ? exact_rank(x.size(), 0.5 * (1.0 - confidence))
                               : normal_rank(x, slopes.size(), confidence);
  if (rank > 0) trend.interval = {slopes[rank - 1], slopes[slopes.size() - rank]};
  return trend;
}

}  // namespace isograsp
