// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/findings/measure_series.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "core/mean.hpp"
#include "reports/findings/wording.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

namespace {

/// Of the days before the last one; the same two as of the verdict, once a day follows them.
void summarise_days(MeasureSeries& series, const std::vector<AssessmentDay>& days) {
  series.last = day_mean(days.back());
  const Baseline base = baseline_of(std::span(days).first(days.size() - 1));
  if (base.days.empty()) return;
  series.baseline = mean_of(base.days);
  const bool passed_over = base.end > base.days.size();
  const bool both = base.days.size() == kBaselineDays;
  if (passed_over)
    series.baseline_basis =
        both ? "first two days with a value"_text : "first day with a value"_text;
  else
    series.baseline_basis = both ? "first two days"_text : "first day"_text;
}

/// Baseline, last and change: of days, or of sessions while there is one day only.
void summarise(MeasureSeries& series, const std::vector<ReportSession>& sessions) {
  const auto days = assessment_days(series, sessions);
  if (days.size() > 1) {
    summarise_days(series, days);
  } else {
    std::vector<double> means;
    for (const auto& value : series.values)
      if (value.mean) means.push_back(*value.mean);
    if (!means.empty() && series.values.back().mean) series.last = means.back();
    if (means.size() > 1) {
      series.baseline = means.front();
      series.baseline_basis = "first session"_text;
    }
  }
  if (series.baseline && series.last) series.change = difference_of(*series.last, *series.baseline);
}

}  // namespace

std::vector<AssessmentDay> assessment_days(const MeasureSeries& series,
                                           const std::vector<ReportSession>& sessions) {
  const bool censored = tasks::words_of(series.name, series.channel).censored;
  std::vector<AssessmentDay> days;
  for (const auto& value : series.values) {
    const double day = sessions[value.session].day;
    if (days.empty() || days.back().day != day) days.push_back({day, {}, false});
    auto& trials = days.back().trials;
    trials.insert(trials.end(), value.trials.begin(), value.trials.end());
    days.back().failed = days.back().failed || (censored && value.without_value > 0);
  }
  // A day on which nothing could be computed is no assessment; the newest must not be passed over.
  const auto is_empty = [&](const AssessmentDay& day) {
    return day.trials.empty() && !day.failed && &day != &days.back();
  };
  std::vector<AssessmentDay> assessed;
  for (const auto& day : days)
    if (!is_empty(day)) assessed.push_back(day);
  return assessed;
}

std::string session_numbers(const std::set<std::size_t>& which,
                            const std::vector<ReportSession>& sessions) {
  std::string text;
  for (const auto session : which)
    text += (text.empty() ? "" : ", ") + std::to_string(sessions[session].number);
  return text;
}

MeasureSeries make_series(const Measure& like, const std::vector<const StoredTrial*>& entries,
                          const std::vector<ReportSession>& sessions, TaskSection& section) {
  MeasureSeries series;
  series.name = like.name;
  series.channel = like.channel;
  series.unit = like.unit;
  series.version = like.version;
  const bool censored = tasks::words_of(like.name, like.channel).censored;
  std::set<std::size_t> other_version;
  for (const StoredTrial* entry : entries)
    for (const auto& measure : entry->measures) {
      if (measure.name != like.name || measure.channel != like.channel) continue;
      if (measure.version != like.version || measure.unit != like.unit) {
        other_version.insert(entry->session);
        continue;
      }
      if (series.values.empty() || series.values.back().session != entry->session)
        series.values.push_back({entry->session, {}, 0, {}, false});
      SessionValue& value = series.values.back();
      if (measure.value)
        value.trials.push_back(*measure.value);
      else
        ++value.without_value;
    }
  for (auto& value : series.values) {
    value.first_day = sessions[value.session].day == sessions[series.values.front().session].day &&
                      sessions[series.values.back().session].day != sessions[value.session].day;
    const bool failed = censored && value.without_value > 0;
    if (!value.trials.empty() && !failed) value.mean = arithmetic_mean(value.trials);
  }
  summarise(series, sessions);
  if (!other_version.empty())
    section.notes.push_back(
        (other_version.size() == 1
             ? "%1: session %2 not compared, another version of the measure"_text
             : "%1: sessions %2 not compared, another version of the measure"_text)(
            measure_title(like.name, like.channel), session_numbers(other_version, sessions)));
  return series;
}

}  // namespace isograsp::reports
