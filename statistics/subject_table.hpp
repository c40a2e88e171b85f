// SPDX-License-Identifier: GPL-3.0-or-later
// The table that statistics of a group begin with: one row per subject, one column per condition,
// all of one unit. NaN: that subject has no value in that condition.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/text.hpp"

namespace isograsp::statistics {

using SubjectTable = Eigen::MatrixXd;

inline constexpr Words kNotComputed = "not computed"_text;

/// Listwise deletion: a subject with a missing value stands in no statistic.
struct CompleteSubjects {
  SubjectTable values;                   ///< of the subjects that are kept
  std::vector<Eigen::Index> kept;        ///< rows of the table
  std::vector<Eigen::Index> incomplete;  ///< rows left out
};
[[nodiscard]] CompleteSubjects complete_subjects(const SubjectTable& table);

/// Why a test that needs so many subjects and conditions cannot be made of the table; empty: it
/// can. Tests take no missing values: call complete_subjects() first.
[[nodiscard]] Text obstacle_of(const SubjectTable& table, Eigen::Index least_subjects,
                               Eigen::Index least_conditions);

/// The same for a test that squares the values, and their squares: the largest of them must lie
/// between 1e-60 and 1e60 in size (or be zero), beyond which those would be 0 or infinite.
[[nodiscard]] Text obstacle_to_squares(const SubjectTable& table, Eigen::Index least_subjects,
                                       Eigen::Index least_conditions);

/// True if a sum of squares (or a squared range) of values of that size is rounding alone: each of
/// `terms` is wrong by at most some ulp.
[[nodiscard]] bool only_rounding(double sum_of_squares, double largest, Eigen::Index terms);

}  // namespace isograsp::statistics
