// SPDX-License-Identifier: GPL-3.0-or-later
// Where a measure is going, whatever single bad days say. Pure statistics, deterministic.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace isograsp {

inline constexpr std::size_t kLeastTrendDays = 5;

/// An estimate with its 95 % interval.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Slope of y over x: the median of the slopes of all pairs (Theil 1950, Sen 1968); a third of the
/// points may be anything. The interval: percentiles of the slopes of resampled points (Efron
/// 1979), with a fixed seed. Nothing: fewer than kLeastTrendDays points, or all at one x.
/// @pre x and y have the same size
[[nodiscard]] std::optional<Estimate> theil_sen(std::span<const double> x,
                                                std::span<const double> y);

/// A day of a censored time: those that came, and how many did not.
struct CensoredDay {
  double x = 0.0;
  std::optional<double> value;  ///< median of the day with misses tied worst; nothing: a miss
  int reached = 0;
  int tried = 0;
};
/// The trend of a time that does not always come, by ranks: Kendall's tau-b (1945) of time and day,
/// days whose median was not reached tied as the longest. -1 … 1; negative: sooner.
struct RankTrend {
  Estimate tau;
  int reached = 0;
  int tried = 0;
};
/// Nothing: fewer than kLeastTrendDays days, or all of one rank.
[[nodiscard]] std::optional<RankTrend> rank_trend(std::span<const CensoredDay> days);

}  // namespace isograsp
