// SPDX-License-Identifier: GPL-3.0-or-later
// Tests on ranks, for values whose differences are not normal or are only ordered: Friedman for
// several conditions, Wilcoxon's signed ranks for two. Pure functions of tables without missing
// values. Rules, sources and limits: docs/statistics.md.
#pragma once

#include <span>
#include <vector>

#include "statistics/samples.hpp"
#include "statistics/subject_table.hpp"

namespace isograsp::statistics {

struct Friedman {
  Eigen::Index subjects = 0;
  Eigen::Index conditions = 0;
  Computed chi2 = kNotComputed;  ///< corrected for ties
  double df = 0.0;
  Computed p = kNotComputed;          ///< from the chi-squared distribution
  Computed kendall_w = kNotComputed;  ///< agreement of the subjects, 0 to 1
  std::vector<double> mean_ranks;     ///< of the conditions
};
[[nodiscard]] Friedman friedman(const SubjectTable& table);

/// P(W+ = s / 2) at index s if each rank counts as positive with probability 1/2; all ties are
/// taken as they are. @pre ranks are multiples of 1/2, at most kMostExactPairs of them
[[nodiscard]] std::vector<double> signed_rank_distribution(std::span<const double> ranks);
/// Up to here counts of sign patterns are whole numbers in a double.
inline constexpr std::size_t kMostExactPairs = 50;

/// Wilcoxon's signed rank test of paired differences.
struct SignedRank {
  Eigen::Index first = 0;  ///< of a pair of conditions: first - second
  Eigen::Index second = 0;
  int pairs = 0;
  int zeros = 0;  ///< differences of zero: left out of ranks and p (Wilcoxon 1949)
  bool ties = false;
  bool exact = false;  ///< p from all sign patterns; else normal, corrected for continuity
  Computed w_plus = kNotComputed;  ///< sum of the ranks of positive differences
  Computed w_minus = kNotComputed;
  Computed z = kNotComputed;  ///< normal approximation, corrected for ties, not for continuity
  Computed p = kNotComputed;  ///< two-sided
  Computed p_bonferroni = kNotComputed;
  Computed r = kNotComputed;              ///< z / √(differences that are not zero)
  Computed rank_biserial = kNotComputed;  ///< (W+ - W-) / (W+ + W-)
  Computed pseudo_median = kNotComputed;  ///< Hodges & Lehmann 1963, of all differences
  Computed low = kNotComputed;  ///< its interval, for all comparisons of the family together
  Computed high = kNotComputed;
};
/// @param tied  differences whose sizes differ by no more are tied; those no larger are zero:
///              tie_width() of the values that were subtracted
/// @param comparisons  in the family: p_bonferroni and the interval @pre all finite
[[nodiscard]] SignedRank signed_rank(std::span<const double> differences, double tied,
                                     int comparisons = 1, double confidence = 0.95);
/// All pairs of columns, in order.
[[nodiscard]] std::vector<SignedRank> signed_rank_pairs(const SubjectTable& table,
                                                        double confidence = 0.95);

}  // namespace isograsp::statistics
