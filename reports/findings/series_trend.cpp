// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/series_trend.hpp"

#include <algorithm>
#include <cstdio>

#include "reports/findings/measure_series.hpp"
#include "reports/findings/wording.hpp"
#include "statistics/robust_trend.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

constexpr double kWeek_days = 7.0;

/// A rank correlation is no measure with a unit: two decimals.
Number rank(double value) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%.2f", value < 0.0 ? -value : value);
  return {(value < 0.0 ? "\u2212" : "") + std::string(digits)};
}

/// Each day with its trials in the order of length, misses last.
std::vector<statistics::CensoredDay> censored_days(const MeasureSeries& series,
                                                   const std::vector<ReportSession>& sessions) {
  struct Day {
    double x;
    std::vector<double> times;
    int missed;
  };
  std::vector<Day> days;
  for (const auto& value : series.values) {
    const double x = sessions[value.session].day / kWeek_days;
    if (days.empty() || days.back().x != x) days.push_back({x, {}, 0});
    days.back().times.insert(days.back().times.end(), value.trials.begin(), value.trials.end());
    days.back().missed += value.without_value;
  }
  std::vector<statistics::CensoredDay> all;
  for (auto& day : days) {
    std::sort(day.times.begin(), day.times.end());
    const int reached = static_cast<int>(day.times.size());
    const int tried = reached + day.missed;
    if (tried == 0) continue;
    statistics::CensoredDay one{day.x, std::nullopt, reached, tried};
    // The upper median: of an even number the worse one, so that half missed counts as missed.
    const auto middle = static_cast<std::size_t>(tried / 2);
    if (middle < day.times.size()) one.value = day.times[middle];
    all.push_back(one);
  }
  return all;
}

}  // namespace

Text trend_words(const MeasureSeries& series, const std::vector<ReportSession>& sessions) {
  if (tasks::words_of(series.name, series.channel).censored) {
    const auto trend = statistics::rank_trend(censored_days(series, sessions));
    if (!trend) return {};
    return "reached in %1 of %2 trials, ranks %3 (%4 to %5)"_text(
        trend->reached, trend->tried, rank(trend->tau.value), rank(trend->tau.low),
        rank(trend->tau.high));
  }
  std::vector<double> weeks;
  std::vector<double> means;
  for (const auto& day : assessment_days(series, sessions))
    if (const auto mean = day_mean(day)) {
      weeks.push_back(day.day / kWeek_days);
      means.push_back(*mean);
    }
  const auto slope = statistics::theil_sen(weeks, means);
  if (!slope) return {};
  const Number change{tasks::format_change(slope->value, series.unit)};
  const auto unit = tasks::printed_unit(series.unit.starts_with("of ") ? "" : series.unit).text;
  return "%1 per week (%2 to %3)"_text(
      unit.empty() ? "%1"_text(change) : "%1\u00a0%2"_text(change, unit),
      value_number(slope->low, series.unit), value_number(slope->high, series.unit));
}

}  // namespace isograsp::reports
