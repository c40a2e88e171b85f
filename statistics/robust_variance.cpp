// SPDX-License-Identifier: GPL-3.0-or-later
// Differences d of pairs with weights w; h = d^2 / 2 estimates the variance of one value:
//   first = weighted median of h / consistency.median
//   kept are those with h <= kKeptSds^2 first
//   variance = (sum w h / sum w, of the kept) / (consistency.kept small_sample_share(count))
//   count = (sum w)^2 / sum w^2, of all
#include "statistics/robust_variance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace isograsp::statistics {

namespace {

/// (a - b)^2 / 2 in units of the largest finite difference squared: it cannot overflow.
struct HalfSquare {
  double value;
  double weight;
};

double sum_of_weights(const std::vector<HalfSquare>& all) {
  double sum = 0.0;
  for (const auto& one : all) sum += one.weight;
  return sum;
}

/// The value that half of the weight does not exceed; the mean of two where it is exactly half.
double weighted_median(const std::vector<HalfSquare>& sorted) {
  constexpr double kRounding = 1e-9;  // of sums of weights
  const double half = sum_of_weights(sorted) / 2.0;
  double passed = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    passed += sorted[i].weight;
    if (passed > half * (1.0 + kRounding)) return sorted[i].value;
    if (passed >= half * (1.0 - kRounding) && i + 1 < sorted.size())
      return (sorted[i].value + sorted[i + 1].value) / 2.0;
  }
  return sorted.back().value;
}

/// How many squares of equal weight tell as much (Kish 1965).
double effective_count(const std::vector<HalfSquare>& all) {
  double squares = 0.0;
  for (const auto& one : all) squares += one.weight * one.weight;
  const double sum = sum_of_weights(all);
  return sum * sum / squares;
}

double weighted_mean(const std::vector<HalfSquare>& all) {
  double sum = 0.0;
  for (const auto& one : all) sum += one.weight * one.value;
  return sum / sum_of_weights(all);
}

}  // namespace

double small_sample_share(double count) {
  constexpr double kLost = 0.2;
  constexpr double kPower = 0.75;
  return 1.0 - kLost * std::pow(count, -kPower);
}

RobustSd robust_sd(std::span<const PairDifference> pairs, const Consistency& consistency,
                   double tied) {
  double unit = 0.0;
  for (const auto& pair : pairs)
    if (std::isfinite(pair.difference)) unit = std::max(unit, std::abs(pair.difference));
  if (unit <= tied) return {};
  std::vector<HalfSquare> all;
  for (const auto& pair : pairs) {
    const double x = std::abs(pair.difference) <= tied ? 0.0 : pair.difference / unit;
    all.push_back(
        {std::isfinite(x) ? x * x / 2.0 : std::numeric_limits<double>::infinity(), pair.weight});
  }
  std::sort(all.begin(), all.end(),
            [](const HalfSquare& a, const HalfSquare& b) { return a.value < b.value; });
  const double count = effective_count(all);
  const double first = weighted_median(all) / consistency.median;
  const bool tells = first > 0.0 && std::isfinite(first);
  const double limit = tells ? kKeptSds * kKeptSds * first : std::numeric_limits<double>::max();
  const auto kept_end = std::find_if(all.begin(), all.end(),
                                     [limit](const HalfSquare& one) { return one.value > limit; });
  const auto left_out = static_cast<int>(all.end() - kept_end);
  all.erase(kept_end, all.end());
  const double variance =
      weighted_mean(all) / (tells ? consistency.kept * small_sample_share(count) : 1.0);
  return {unit * std::sqrt(variance), left_out};
}

}  // namespace isograsp::statistics
