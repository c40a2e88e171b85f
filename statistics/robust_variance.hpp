// SPDX-License-Identifier: GPL-3.0-or-later
// A variance from differences of pairs, some of which are outliers: one day with a swollen hand
// must not decide what counts as a change for everybody. Formula and source: docs/change.md.
#pragma once

#include <span>

namespace isograsp::statistics {

/// Two values of the same thing.
struct PairDifference {
  double difference = 0.0;  ///< of any sign; infinite or not a number: an outlier
  double weight = 1.0;      ///< > 0
};

/// Factors that make the estimate right for values without outliers, as shares of their variance.
struct Consistency {
  double median;  ///< of (a - b)^2 / 2
  double kept;    ///< mean of what lies within kKeptSds
};
/// Pairs are left out beyond so many robust standard deviations.
inline constexpr double kKeptSds = 3.0;
/// All have one variance: of chi-squared with one degree of freedom.
inline constexpr Consistency kOneVariance{0.45493642, 0.97333692};
/// Normal with standard deviations between 1 and 2, all equally likely (10 to 20 %).
inline constexpr Consistency kUnequalVariances{0.41363067, 0.94449647};

/// Of few values both steps give a variance that is a little too small: on average this share of
/// it, within 0.01 from ten values on (docs/change.md). @param count  of values of equal weight
[[nodiscard]] double small_sample_share(double count);

struct RobustSd {
  double sd = 0.0;   ///< of one of the values that were subtracted; their unit
  int left_out = 0;  ///< pairs
};
/// (a - b)^2 / 2 estimates the variance of a. A first estimate from the median of these squares
/// says which are no more than kKeptSds away; the second is the mean of those, corrected for their
/// small number. Where half of the pairs do not differ at all (by more than `tied`), the median
/// says nothing: then all finite ones count. @pre not empty
[[nodiscard]] RobustSd robust_sd(std::span<const PairDifference> pairs,
                                 const Consistency& consistency, double tied);

}  // namespace isograsp::statistics
