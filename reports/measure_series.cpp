// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/measure_series.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "reports/measure_words.hpp"

namespace isograsp {

namespace {

/// Baseline, last and change from the session means (the baseline is the mean of two days).
void summarise(MeasureSeries& series, const std::vector<ReportSession>& sessions) {
  std::vector<std::pair<int, double>> means;  // day, mean
  for (const auto& value : series.values)
    if (value.mean) means.emplace_back(sessions[value.session].day, *value.mean);
  if (means.empty()) return;
  if (series.values.back().mean) series.last = means.back().second;
  std::vector<int> days;
  for (const auto& [day, mean] : means)
    if (days.empty() || days.back() != day) days.push_back(day);
  if (means.size() < 2) return;
  std::size_t used = 1;
  series.baseline_basis = "first session";
  if (days.size() >= 2) {
    const int last_day = days.size() >= 3 ? days[1] : days[0];
    series.baseline_basis = days.size() >= 3 ? "first two days" : "first day";
    used = static_cast<std::size_t>(std::count_if(
        means.begin(), means.end(), [&](const auto& mean) { return mean.first <= last_day; }));
  }
  series.baseline =
      std::accumulate(means.begin(), means.begin() + static_cast<long>(used), 0.0,
                      [](double sum, const auto& mean) { return sum + mean.second; }) /
      static_cast<double>(used);
  if (series.last) series.change = *series.last - *series.baseline;
}

}  // namespace

std::string list_sessions(const std::set<std::size_t>& sessions) {
  std::string text = sessions.size() == 1 ? "session " : "sessions ";
  std::string separator;
  for (const auto session : sessions) {
    text += separator + std::to_string(session + 1);
    separator = ", ";
  }
  return text;
}

MeasureSeries make_series(const Measure& like, const std::vector<const StoredTrial*>& entries,
                          const std::vector<ReportSession>& sessions, TaskSection& section) {
  MeasureSeries series{like.name, like.channel, like.unit, like.version, false, false,
                       {},        {},           "",        {},           {},    ""};
  const bool censored = words_for(like.name, like.channel).censored;
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
    if (!value.trials.empty() && !failed)
      value.mean = std::accumulate(value.trials.begin(), value.trials.end(), 0.0) /
                   static_cast<double>(value.trials.size());
  }
  summarise(series, sessions);
  if (!other_version.empty())
    section.notes.push_back(words_for(like.name, like.channel).title + ": " +
                            list_sessions(other_version) +
                            " not compared, another version of the measure");
  return series;
}

}  // namespace isograsp
