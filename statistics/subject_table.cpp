// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/subject_table.hpp"

#include <limits>

namespace isograsp::statistics {

CompleteSubjects complete_subjects(const SubjectTable& table) {
  CompleteSubjects result;
  for (Eigen::Index row = 0; row < table.rows(); ++row)
    (table.row(row).allFinite() ? result.kept : result.incomplete).push_back(row);
  result.values = table(result.kept, Eigen::all);
  return result;
}

Text obstacle_of(const SubjectTable& table, Eigen::Index least_subjects,
                 Eigen::Index least_conditions) {
  if (table.cols() < least_conditions)
    return "needs at least %1 conditions, has %2"_text(least_conditions, table.cols());
  if (table.rows() < least_subjects)
    return "needs at least %1 subjects, has %2"_text(least_subjects, table.rows());
  if (!table.allFinite()) return "a value is missing"_text;
  return {};
}

Text obstacle_to_squares(const SubjectTable& table, Eigen::Index least_subjects,
                         Eigen::Index least_conditions) {
  if (auto why = obstacle_of(table, least_subjects, least_conditions); !why.empty()) return why;
  constexpr double kLargest = 1e60;
  const double largest = table.cwiseAbs().maxCoeff();
  if (largest > kLargest) return "the values are too large to be squared, choose another unit"_text;
  if (largest > 0.0 && largest < 1.0 / kLargest)
    return "the values are too small to be squared, choose another unit"_text;
  return {};
}

bool only_rounding(double sum_of_squares, double largest, Eigen::Index terms) {
  constexpr double kUlps = 16.0;  // of the means and contrasts that are subtracted
  const double error = kUlps * std::numeric_limits<double>::epsilon() * largest;
  return sum_of_squares <= static_cast<double>(terms) * error * error;
}

}  // namespace isograsp::statistics
