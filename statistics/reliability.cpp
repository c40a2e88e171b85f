// SPDX-License-Identifier: GPL-3.0-or-later
// Two ways, absolute agreement, one measurement; n subjects, k repeats, MS the mean squares:
//   ICC(A,1) = (MS_subjects - MS_error) /
//              (MS_subjects + (k - 1) MS_error + k (MS_repeats - MS_error) / n)
//   SEM = sqrt((MS_repeats - MS_error) / n + MS_error),  MDC95 = 1.96 sqrt(2) SEM
#include "statistics/reliability.hpp"

#include <cmath>
#include <numbers>

#include <boost/math/distributions/fisher_f.hpp>

namespace isograsp::statistics {

namespace {

using boost::math::complement;

constexpr double squared(double x) {
  return x * x;
}

double f_quantile(double tail, double df, double error_df) {
  return quantile(complement(boost::math::fisher_f(df, error_df), tail));
}

/// McGraw & Wong 1996, table 7, case 2, ICC(A,1).
void set_interval(Reliability& result, double icc, double confidence) {
  const auto n = static_cast<double>(result.subjects);
  const auto k = static_cast<double>(result.repeats);
  const double of_subjects = result.subjects_mean_square;
  const double of_repeats = result.repeats_mean_square;
  const double error = result.error_mean_square;
  // Weights of the two mean squares, times 1 - ICC.
  const double a = k * icc / n;
  const double b = 1.0 - icc + k * icc * (n - 1.0) / n;
  const double df =
      squared(a * of_repeats + b * error) /
      (squared(a * of_repeats) / (k - 1.0) + squared(b * error) / ((n - 1.0) * (k - 1.0)));
  if (!(df > 0.0)) {
    result.low = result.high = "repeats do not differ at all"_text;
    return;
  }
  const double tail = (1.0 - confidence) / 2.0;
  const double rest = k * of_repeats + (k * n - k - n) * error;
  const double f_low = f_quantile(tail, n - 1.0, df);
  const double f_high = f_quantile(tail, df, n - 1.0);
  result.low = n * (of_subjects - f_low * error) / (f_low * rest + n * of_subjects);
  result.high = n * (f_high * of_subjects - error) / (rest + n * f_high * of_subjects);
}

}  // namespace

Reliability reliability(const SubjectTable& table, double confidence) {
  Reliability result;
  result.subjects = table.rows();
  result.repeats = table.cols();
  const auto undefined = [&result](const Text& why) {
    for (Computed* one : {&result.icc, &result.low, &result.high, &result.sem, &result.mdc95})
      *one = why;
    return result;
  };
  if (const auto why = obstacle_to_squares(table, 2, 2); !why.empty()) return undefined(why);
  const auto n = static_cast<double>(table.rows());
  const auto k = static_cast<double>(table.cols());
  const double grand = table.mean();
  if (only_rounding((table.array() - grand).matrix().squaredNorm(), table.cwiseAbs().maxCoeff(),
                    table.size()))
    return undefined("all values are equal"_text);
  const Eigen::VectorXd of_subjects = table.rowwise().mean();
  const Eigen::RowVectorXd of_repeats = table.colwise().mean();
  const SubjectTable error =
      (table.colwise() - of_subjects).rowwise() - (of_repeats.array() - grand).matrix();
  result.subjects_mean_square =
      k * (of_subjects.array() - grand).matrix().squaredNorm() / (n - 1.0);
  result.repeats_mean_square = n * (of_repeats.array() - grand).matrix().squaredNorm() / (k - 1.0);
  result.error_mean_square = error.squaredNorm() / ((n - 1.0) * (k - 1.0));
  const double of_both = (result.repeats_mean_square - result.error_mean_square) / n;
  const double icc =
      (result.subjects_mean_square - result.error_mean_square) /
      (result.subjects_mean_square + (k - 1.0) * result.error_mean_square + k * of_both);
  result.icc = icc;
  set_interval(result, icc, confidence);
  const double sem = std::sqrt(of_both + result.error_mean_square);
  constexpr double kTwoSided95 = 1.96;
  result.sem = sem;
  result.mdc95 = kTwoSided95 * std::numbers::sqrt2 * sem;
  return result;
}

}  // namespace isograsp::statistics
