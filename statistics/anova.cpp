// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of C: orthonormal contrasts; n subjects, scores = table C^T, m their mean:
//   SS = n |m|^2,  SS_error = sum |scores - m|^2
//   df = rows of C,  error_df = df (n - 1),  F = (SS / df) / (SS_error / error_df)
// Sphericity, with the p eigenvalues l of the scatter of the scores:
//   epsilon (Greenhouse, Geisser) = (sum l)^2 / (p sum l^2)
//   w (Mauchly) = product of l / mean of l
#include "statistics/anova.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace isograsp::statistics {

namespace {

using boost::math::cdf;
using boost::math::complement;
using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index kLeastSubjects = 2;
constexpr Words kNoError =
    "subjects do not differ in the effect: there is no error to test with"_text;

double f_tail(double f, double df, double error_df) {
  return cdf(complement(boost::math::fisher_f(df, error_df), f));
}

/// Rows: orthonormal contrasts of `count` conditions, each with the mean of those before (Helmert).
MatrixXd contrasts(Index count) {
  MatrixXd rows = MatrixXd::Zero(count - 1, count);
  for (Index row = 0; row + 1 < count; ++row) {
    const double before = static_cast<double>(row + 1);
    const double scale = 1.0 / std::sqrt(before * (before + 1.0));
    rows.row(row).head(row + 1).setConstant(scale);
    rows(row, row + 1) = -before * scale;
  }
  return rows;
}

/// One row: the mean of `count` conditions, of length 1.
MatrixXd mean_of(Index count) {
  return MatrixXd::Constant(1, count, 1.0 / std::sqrt(static_cast<double>(count)));
}

/// Contrasts of two factors at once (Kronecker product).
MatrixXd crossed(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd product(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      product.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return product;
}

/// @param scatter  of the contrasts over the subjects, about their mean; not zero
Sphericity sphericity_of(const MatrixXd& scatter, Index subjects) {
  Sphericity result;
  const Index contrasts_count = scatter.rows();
  if (contrasts_count == 1) {
    result.epsilon = result.epsilon_huynh_feldt = 1.0;
    for (Computed* one :
         {&result.mauchly_w, &result.mauchly_chi2, &result.mauchly_df, &result.mauchly_p})
      *one = "one difference only: sphericity cannot be violated"_text;
    return result;
  }
  const auto p = static_cast<double>(contrasts_count);
  const auto df = static_cast<double>(subjects - 1);
  const Eigen::VectorXd variances =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(scatter, Eigen::EigenvaluesOnly)
          .eigenvalues()
          .cwiseMax(0.0);
  const double epsilon =
      std::clamp(variances.sum() * variances.sum() / (p * variances.squaredNorm()), 1.0 / p, 1.0);
  result.epsilon = epsilon;
  const double spread = p * (df - p * epsilon);
  result.epsilon_huynh_feldt =
      spread > 0.0 ? std::min(1.0, ((df + 1.0) * p * epsilon - 2.0) / spread) : 1.0;
  if (subjects <= contrasts_count) {
    for (Computed* one :
         {&result.mauchly_w, &result.mauchly_chi2, &result.mauchly_df, &result.mauchly_p})
      *one = "needs at least %1 subjects, has %2"_text(contrasts_count + 1, subjects);
    return result;
  }
  const double w = (variances / variances.mean()).prod();
  const double f = p * (p + 1.0) / 2.0 - 1.0;
  result.mauchly_w = w;
  result.mauchly_df = f;
  // Relative to 1: w is a product of ratios of variances, each exact to some ulp.
  constexpr double kSingular = 1e-14;
  if (w < kSingular) {
    result.mauchly_chi2 = result.mauchly_p = "a difference between conditions does not vary"_text;
    return result;
  }
  // Box 1949 to the second order; Anderson, "An introduction to multivariate statistical
  // analysis", section 10.7.
  const double rho = 1.0 - (2.0 * p * p + p + 2.0) / (6.0 * p * df);
  const double second = (p + 2.0) * (p - 1.0) * (p - 2.0) *
                        (2.0 * p * p * p + 6.0 * p * p + 3.0 * p + 2.0) /
                        (288.0 * p * p * df * df * rho * rho);
  const double chi2 = std::max(0.0, -df * rho * std::log(w));
  const auto tail = [chi2](double of_df) {
    return cdf(complement(boost::math::chi_squared(of_df), chi2));
  };
  const double first_order = tail(f);
  result.mauchly_chi2 = chi2;
  result.mauchly_p = std::clamp(first_order + second * (tail(f + 4.0) - first_order), 0.0, 1.0);
  return result;
}

void undefine(WithinEffect& effect, const Text& why) {
  for (Computed* one :
       {&effect.f, &effect.p, &effect.sphericity.epsilon, &effect.sphericity.epsilon_huynh_feldt,
        &effect.sphericity.mauchly_w, &effect.sphericity.mauchly_chi2,
        &effect.sphericity.mauchly_df, &effect.sphericity.mauchly_p, &effect.corrected_df,
        &effect.corrected_error_df, &effect.corrected_p, &effect.partial_eta2,
        &effect.generalised_eta2})
    *one = why;
}

/// The effect of orthonormal contrasts, compared with their variation between subjects.
WithinEffect effect_of(const SubjectTable& table, const MatrixXd& of_contrasts) {
  WithinEffect effect;
  const Index n = table.rows();
  const MatrixXd scores = table * of_contrasts.transpose();
  const Eigen::RowVectorXd mean = scores.colwise().mean();
  const MatrixXd about = scores.rowwise() - mean;
  effect.sum_of_squares = static_cast<double>(n) * mean.squaredNorm();
  effect.error_sum_of_squares = about.squaredNorm();
  effect.df = static_cast<double>(of_contrasts.rows());
  effect.error_df = effect.df * static_cast<double>(n - 1);
  if (only_rounding(effect.error_sum_of_squares, table.cwiseAbs().maxCoeff(), table.size())) {
    undefine(effect, kNoError);
    return effect;
  }
  const double f =
      effect.sum_of_squares / effect.df / (effect.error_sum_of_squares / effect.error_df);
  effect.f = f;
  effect.p = f_tail(f, effect.df, effect.error_df);
  effect.sphericity = sphericity_of(about.transpose() * about, n);
  const double epsilon = *effect.sphericity.epsilon.value;
  effect.corrected_df = epsilon * effect.df;
  effect.corrected_error_df = epsilon * effect.error_df;
  effect.corrected_p = f_tail(f, epsilon * effect.df, epsilon * effect.error_df);
  effect.partial_eta2 =
      effect.sum_of_squares / (effect.sum_of_squares + effect.error_sum_of_squares);
  return effect;
}

/// Sum of squares of the subjects' means.
double subjects_sum(const SubjectTable& table) {
  const Eigen::VectorXd means = table.rowwise().mean();
  return static_cast<double>(table.cols()) * (means.array() - means.mean()).matrix().squaredNorm();
}

void generalise(WithinEffect& effect, double all_errors) {
  if (effect.f.value)
    effect.generalised_eta2 = effect.sum_of_squares / (effect.sum_of_squares + all_errors);
}

PairedT pair_of(const SubjectTable& table, Index first, Index second, double comparisons,
                double confidence) {
  PairedT pair;
  pair.first = first;
  pair.second = second;
  const Eigen::VectorXd difference = table.col(first) - table.col(second);
  const Index n = table.rows();
  const double mean = difference.mean();
  pair.mean_difference = mean;
  pair.df = static_cast<double>(n - 1);
  const double squares = (difference.array() - mean).matrix().squaredNorm();
  const double largest =
      std::max(table.col(first).cwiseAbs().maxCoeff(), table.col(second).cwiseAbs().maxCoeff());
  if (only_rounding(squares, largest, n)) {
    pair.sd = 0.0;
    for (Computed* one : {&pair.t, &pair.p, &pair.p_bonferroni, &pair.low, &pair.high, &pair.d_z})
      *one = "the difference is the same in all subjects"_text;
    return pair;
  }
  const double sd = std::sqrt(squares / pair.df);
  const double error = sd / std::sqrt(static_cast<double>(n));
  const boost::math::students_t student(pair.df);
  pair.sd = sd;
  pair.t = mean / error;
  const double p = 2.0 * cdf(complement(student, std::abs(mean / error)));
  pair.p = p;
  pair.p_bonferroni = std::min(1.0, comparisons * p);
  const double reach =
      error * quantile(complement(student, (1.0 - confidence) / (2.0 * comparisons)));
  pair.low = mean - reach;
  pair.high = mean + reach;
  pair.d_z = mean / sd;
  return pair;
}

}  // namespace

OneWayAnova one_way_anova(const SubjectTable& table) {
  OneWayAnova result;
  result.subjects = table.rows();
  if (const auto why = obstacle_to_squares(table, kLeastSubjects, 2); !why.empty()) {
    undefine(result.effect, why);
    return result;
  }
  result.effect = effect_of(table, contrasts(table.cols()));
  result.subjects_sum_of_squares = subjects_sum(table);
  generalise(result.effect, result.subjects_sum_of_squares + result.effect.error_sum_of_squares);
  return result;
}

TwoWayAnova two_way_anova(const SubjectTable& table, Index levels_a, Index levels_b) {
  assert(table.cols() == levels_a * levels_b);
  TwoWayAnova result;
  result.subjects = table.rows();
  auto why = obstacle_to_squares(table, kLeastSubjects, 4);
  if (why.empty() && (levels_a < 2 || levels_b < 2))
    why = "needs at least 2 levels of each factor"_text;
  if (!why.empty()) {
    for (auto* effect : {&result.a, &result.b, &result.interaction}) undefine(*effect, why);
    return result;
  }
  result.a = effect_of(table, crossed(contrasts(levels_a), mean_of(levels_b)));
  result.b = effect_of(table, crossed(mean_of(levels_a), contrasts(levels_b)));
  result.interaction = effect_of(table, crossed(contrasts(levels_a), contrasts(levels_b)));
  result.subjects_sum_of_squares = subjects_sum(table);
  double all_errors = result.subjects_sum_of_squares;
  for (const auto* effect : {&result.a, &result.b, &result.interaction})
    all_errors += effect->error_sum_of_squares;
  for (auto* effect : {&result.a, &result.b, &result.interaction}) generalise(*effect, all_errors);
  return result;
}

std::vector<PairedT> bonferroni_pairs(const SubjectTable& table, double confidence) {
  const auto why = obstacle_to_squares(table, kLeastSubjects, 2);
  const auto comparisons = static_cast<double>(table.cols() * (table.cols() - 1)) / 2.0;
  std::vector<PairedT> pairs;
  for (Index first = 0; first < table.cols(); ++first)
    for (Index second = first + 1; second < table.cols(); ++second) {
      if (why.empty()) {
        pairs.push_back(pair_of(table, first, second, comparisons, confidence));
        continue;
      }
      PairedT pair;
      pair.first = first;
      pair.second = second;
      for (Computed* one : {&pair.mean_difference, &pair.sd, &pair.t, &pair.p, &pair.p_bonferroni,
                            &pair.low, &pair.high, &pair.d_z})
        *one = why;
      pairs.push_back(pair);
    }
  return pairs;
}

}  // namespace isograsp::statistics
