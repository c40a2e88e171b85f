// SPDX-License-Identifier: GPL-3.0-or-later
// Friedman: n subjects, k conditions, r a rank, R_j the sum of the ranks of condition j:
//   chi2 = (k - 1) sum_j (R_j - n (k + 1) / 2)^2 / sum (r - (k + 1) / 2)^2
//   Kendall's W = chi2 / (n (k - 1))
// Wilcoxon: W+ is the sum of the ranks of the positive differences; without an effect each of the
// 2^n patterns of signs is equally likely.
//   pseudo-median = median of the Walsh averages (d_i + d_j) / 2, i <= j
#include "statistics/rank_tests.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include "core/ties.hpp"
#include "statistics/percentile.hpp"

namespace isograsp::statistics {

namespace {

using boost::math::cdf;
using boost::math::complement;
using Eigen::Index;

double sum_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Exact for whole numbers below 2^53.
double two_sided(const std::vector<double>& distribution, double w) {
  const auto at = static_cast<std::ptrdiff_t>(std::lround(2.0 * w));
  const double below = std::accumulate(distribution.begin(), distribution.begin() + at + 1, 0.0);
  const double above = std::accumulate(distribution.begin() + at, distribution.end(), 0.0);
  return std::min(1.0, 2.0 * std::min(below, above));
}

/// Means of all pairs of differences, each with itself too; sorted.
std::vector<double> walsh_averages(std::span<const double> differences) {
  std::vector<double> means;
  means.reserve(differences.size() * (differences.size() + 1) / 2);
  for (std::size_t i = 0; i < differences.size(); ++i)
    for (std::size_t j = i; j < differences.size(); ++j)
      means.push_back(std::midpoint(differences[i], differences[j]));
  std::sort(means.begin(), means.end());
  return means;
}

/// How many Walsh averages lie outside an interval of error rate `alpha`, on each side; 0: the
/// interval has no end.
std::size_t outside(std::size_t n, double alpha) {
  const auto count = static_cast<double>(n);
  if (n > kMostExactPairs) {
    const double mean = count * (count + 1.0) / 4.0;
    const double sd = std::sqrt(mean * (2.0 * count + 1.0) / 6.0);
    const double z = quantile(complement(boost::math::normal(), alpha / 2.0));
    return static_cast<std::size_t>(std::max(0.0, std::floor(mean - z * sd)));
  }
  std::vector<double> ranks(n);
  std::iota(ranks.begin(), ranks.end(), 1.0);
  const auto distribution = signed_rank_distribution(ranks);
  double below = 0.0;
  std::size_t w = 0;
  while (2 * w < distribution.size() && below + distribution[2 * w] <= alpha / 2.0)
    below += distribution[2 * w++];
  return w;
}

void locate(SignedRank& test, std::span<const double> differences, int comparisons,
            double confidence) {
  const auto means = walsh_averages(differences);
  test.pseudo_median = median(means);
  const std::size_t out = outside(differences.size(), (1.0 - confidence) / comparisons);
  if (out == 0) {
    test.low = test.high = "too few differences for an interval"_text;
    return;
  }
  test.low = means[out - 1];
  test.high = means[means.size() - out];
}

}  // namespace

Friedman friedman(const SubjectTable& table) {
  Friedman result;
  result.subjects = table.rows();
  result.conditions = table.cols();
  if (const auto why = obstacle_of(table, 2, 2); !why.empty()) {
    result.chi2 = result.p = result.kendall_w = why;
    return result;
  }
  const auto n = static_cast<double>(table.rows());
  const auto k = static_cast<double>(table.cols());
  result.df = k - 1.0;
  Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(table.cols());
  double squares = 0.0;  // of ranks about their mean, over all subjects
  const double mean_rank = (k + 1.0) / 2.0;
  // Of the whole table: the values of one person may all be near zero and then give no scale.
  const double width = tie_width({table.data(), static_cast<std::size_t>(table.size())});
  for (Index row = 0; row < table.rows(); ++row) {
    const Eigen::RowVectorXd values = table.row(row);
    const auto of_row = mid_ranks({values.data(), static_cast<std::size_t>(values.size())}, width);
    const Eigen::Map<const Eigen::RowVectorXd> ranks(of_row.data(), values.size());
    sums += ranks;
    squares += (ranks.array() - mean_rank).square().sum();
  }
  for (Index column = 0; column < table.cols(); ++column)
    result.mean_ranks.push_back(sums[column] / n);
  if (squares == 0.0) {
    result.chi2 = result.p = result.kendall_w = "all values of each subject are equal"_text;
    return result;
  }
  const double between = (sums.array() - n * mean_rank).square().sum();
  const double chi2 = (k - 1.0) * between / squares;
  result.chi2 = chi2;
  result.p = cdf(complement(boost::math::chi_squared(result.df), chi2));
  result.kendall_w = chi2 / (n * (k - 1.0));
  return result;
}

std::vector<double> signed_rank_distribution(std::span<const double> ranks) {
  assert(ranks.size() <= kMostExactPairs);
  std::vector<double> patterns{1.0};  // patterns[s]: how many give W+ = s / 2
  for (const double rank : ranks) {
    const auto shift = static_cast<std::size_t>(std::lround(2.0 * rank));
    std::vector<double> next(patterns.size() + shift, 0.0);
    for (std::size_t s = 0; s < patterns.size(); ++s) {
      next[s] += patterns[s];
      next[s + shift] += patterns[s];
    }
    patterns = std::move(next);
  }
  for (double& count : patterns) count = std::ldexp(count, -static_cast<int>(ranks.size()));
  return patterns;
}

SignedRank signed_rank(std::span<const double> differences, double tied, int comparisons,
                       double confidence) {
  SignedRank test;
  test.pairs = static_cast<int>(differences.size());
  if (differences.empty()) return test;
  std::vector<double> used;
  std::vector<double> sizes;
  for (const double difference : differences)
    if (std::abs(difference) > tied) {
      used.push_back(difference);
      sizes.push_back(std::abs(difference));
    }
  test.zeros = test.pairs - static_cast<int>(used.size());
  locate(test, differences, comparisons, confidence);
  if (used.empty()) {
    for (Computed* one : {&test.w_plus, &test.w_minus, &test.z, &test.p, &test.p_bonferroni,
                          &test.r, &test.rank_biserial})
      *one = "all differences are zero"_text;
    return test;
  }
  const auto ranks = mid_ranks(sizes, tied);
  const double all = sum_of(ranks);
  double plus = 0.0;
  double variance = 0.0;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (used[i] > 0.0) plus += ranks[i];
    variance += ranks[i] * ranks[i] / 4.0;
  }
  auto sorted = ranks;
  std::sort(sorted.begin(), sorted.end());
  test.ties = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  test.w_plus = plus;
  test.w_minus = all - plus;
  const double above = plus - all / 2.0;
  const double z = above / std::sqrt(variance);
  test.z = z;
  test.r = z / std::sqrt(static_cast<double>(used.size()));
  test.rank_biserial = 2.0 * above / all;
  test.exact = used.size() <= kMostExactPairs;
  double p = 0.0;
  if (test.exact) {
    p = two_sided(signed_rank_distribution(ranks), plus);
  } else {
    const double step = std::max(0.0, std::abs(above) - 0.5) / std::sqrt(variance);
    p = std::min(1.0, 2.0 * cdf(complement(boost::math::normal(), step)));
  }
  test.p = p;
  test.p_bonferroni = std::min(1.0, comparisons * p);
  return test;
}

std::vector<SignedRank> signed_rank_pairs(const SubjectTable& table, double confidence) {
  const auto obstacle = obstacle_of(table, 1, 2);
  const auto comparisons = static_cast<int>(table.cols() * (table.cols() - 1) / 2);
  std::vector<SignedRank> tests;
  for (Index first = 0; first < table.cols(); ++first)
    for (Index second = first + 1; second < table.cols(); ++second) {
      SignedRank test;
      const Eigen::VectorXd difference = table.col(first) - table.col(second);
      const auto why = obstacle.empty() && !difference.allFinite()
                           ? "the differences are too large for a number of the computer"_text
                           : obstacle;
      if (why.empty()) {
        const double largest = std::max(table.col(first).cwiseAbs().maxCoeff(),
                                        table.col(second).cwiseAbs().maxCoeff());
        test = signed_rank({difference.data(), static_cast<std::size_t>(difference.size())},
                           kTied * largest, comparisons, confidence);
      } else {
        for (Computed* one :
             {&test.w_plus, &test.w_minus, &test.z, &test.p, &test.p_bonferroni, &test.r,
              &test.rank_biserial, &test.pseudo_median, &test.low, &test.high})
          *one = why;
      }
      test.first = first;
      test.second = second;
      tests.push_back(std::move(test));
    }
  return tests;
}

}  // namespace isograsp::statistics
