// SPDX-License-Identifier: GPL-3.0-or-later
// Repeated-measures analysis of variance, one and two factors, all within subjects; and the
// comparison of all pairs of conditions. Pure functions of a table without missing values.
// Formulas, sources and limits: docs/statistics.md.
#pragma once

#include <string>
#include <vector>

#include "statistics/samples.hpp"
#include "statistics/subject_table.hpp"

namespace isograsp::statistics {

/// Are the differences between the conditions equally variable?
struct Sphericity {
  Computed epsilon = kNotComputed;              ///< Greenhouse & Geisser 1959, from 1/df to 1
  Computed epsilon_huynh_feldt = kNotComputed;  ///< Huynh & Feldt 1976, at most 1
  Computed mauchly_w = kNotComputed;            ///< Mauchly 1940
  Computed mauchly_chi2 = kNotComputed;         ///< Box's approximation
  Computed mauchly_df = kNotComputed;
  Computed mauchly_p = kNotComputed;
};

/// One effect, tested against its own interaction with the subjects.
struct WithinEffect {
  double sum_of_squares = 0.0;  ///< unit of the values, squared
  double error_sum_of_squares = 0.0;
  double df = 0.0;
  double error_df = 0.0;
  Computed f = kNotComputed;
  Computed p = kNotComputed;  ///< if sphericity holds
  Sphericity sphericity;
  Computed corrected_df = kNotComputed;  ///< times epsilon
  Computed corrected_error_df = kNotComputed;
  Computed corrected_p = kNotComputed;
  Computed partial_eta2 = kNotComputed;  ///< SS / (SS + its error)
  Computed generalised_eta2 =
      kNotComputed;  ///< Olejnik & Algina 2003: SS / (SS + all that subjects differ by)
};

/// @param table  subjects x conditions. An undefined analysis has f, p and so on with the reason.
struct OneWayAnova {
  Eigen::Index subjects = 0;
  WithinEffect effect;
  double subjects_sum_of_squares = 0.0;
};
[[nodiscard]] OneWayAnova one_way_anova(const SubjectTable& table);

/// @param table  subjects x (levels_a levels_b), column a levels_b + b
struct TwoWayAnova {
  Eigen::Index subjects = 0;
  WithinEffect a;
  WithinEffect b;
  WithinEffect interaction;
  double subjects_sum_of_squares = 0.0;
};
/// @pre table.cols() == levels_a * levels_b
[[nodiscard]] TwoWayAnova two_way_anova(const SubjectTable& table, Eigen::Index levels_a,
                                        Eigen::Index levels_b);

/// Paired t test of two conditions, `first` minus `second`, as one of `comparisons` of a family.
struct PairedT {
  Eigen::Index first = 0;
  Eigen::Index second = 0;
  Computed mean_difference = kNotComputed;
  Computed sd = kNotComputed;  ///< of the differences, n - 1
  Computed t = kNotComputed;
  double df = 0.0;
  Computed p = kNotComputed;
  Computed p_bonferroni = kNotComputed;  ///< times the number of comparisons, at most 1
  Computed low = kNotComputed;           ///< of the interval that all comparisons hold together
  Computed high = kNotComputed;
  Computed d_z = kNotComputed;  ///< mean_difference / sd (Cohen 1988)
};
/// All pairs of columns, in order. @pre 0 < confidence < 1
[[nodiscard]] std::vector<PairedT> bonferroni_pairs(const SubjectTable& table,
                                                    double confidence = 0.95);

}  // namespace isograsp::statistics
