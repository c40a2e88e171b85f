// SPDX-License-Identifier: GPL-3.0-or-later
// How well repeated measurements of the same people agree: ICC(2,1), its interval, the standard
// error of measurement and the smallest detectable change of a group. Pure function of a table
// without missing values. Formulas, sources and limits: docs/statistics.md. Verdicts on one person
// (docs/change.md) do not use it.
#pragma once

#include "statistics/samples.hpp"
#include "statistics/subject_table.hpp"

namespace isograsp::statistics {

struct Reliability {
  Eigen::Index subjects = 0;
  Eigen::Index repeats = 0;
  // Mean squares of the two-way table, unit of the values squared.
  double subjects_mean_square = 0.0;
  double repeats_mean_square = 0.0;
  double error_mean_square = 0.0;
  /// Two-way random effects, single measurement, absolute agreement (Shrout & Fleiss 1979).
  Computed icc = kNotComputed;
  Computed low = kNotComputed;  ///< McGraw & Wong 1996
  Computed high = kNotComputed;
  Computed sem = kNotComputed;    ///< √(repeats + error variance), unit of the values
  Computed mdc95 = kNotComputed;  ///< 1.96 √2 SEM
};
/// @param table  subjects x repeats @pre 0 < confidence < 1
[[nodiscard]] Reliability reliability(const SubjectTable& table, double confidence = 0.95);

}  // namespace isograsp::statistics
