// SPDX-License-Identifier: GPL-3.0-or-later
// Trends of a measure that single bad days do not change. Pure statistics, deterministic.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace isograsp::statistics {

inline constexpr std::size_t kLeastTrendDays = 5;

/// An estimate with its 95 % interval.
struct Estimate {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// How an interval is found: percentiles of the estimates of resampled points (Efron 1979). The
/// same points give the same interval everywhere; docs/report.md says how, draw by draw.
struct Bootstrap {
  int resamples = 10000;
  std::uint64_t seed = 1968;
  friend bool operator==(const Bootstrap&, const Bootstrap&) = default;
};

/// Slope of y over x: the median of the slopes of all pairs (Theil 1950, Sen 1968). Up to a quarter
/// of the points may be wrong by any amount. Nothing: fewer than kLeastTrendDays points, all at one
/// x, or values so large that a slope is no number. @pre x and y have the same size
[[nodiscard]] std::optional<Estimate> theil_sen(std::span<const double> x,
                                                std::span<const double> y,
                                                const Bootstrap& bootstrap = {});

/// A day of a censored time: the times of the events that came, and how many did not come.
struct CensoredDay {
  double x = 0.0;
  std::optional<double> value;  ///< median of the day with misses tied worst; nothing: a miss
  int reached = 0;
  int tried = 0;
};
/// Trend of the time to an event that does not always come, by ranks: Kendall's tau-b (1945) of
/// time and day. Days whose median was not reached are tied as the longest. -1 … 1; negative:
/// sooner.
struct RankTrend {
  Estimate tau;
  int reached = 0;
  int tried = 0;
};
/// Times and days that are tied (ties.hpp) have one rank. Nothing: fewer than kLeastTrendDays days,
/// or all of one rank.
[[nodiscard]] std::optional<RankTrend> rank_trend(std::span<const CensoredDay> days,
                                                  const Bootstrap& bootstrap = {});

}  // namespace isograsp::statistics
