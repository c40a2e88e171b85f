// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/clinic/closing.hpp"

#include <QObject>
#include <algorithm>

#include "gui/words/texts.hpp"
#include "gui/words/words.hpp"
#include "reports/findings/limits.hpp"
#include "reports/findings/report_text.hpp"

namespace isograsp::gui {

namespace {

struct Candidate {
  const reports::TaskSection* section = nullptr;
  const reports::MeasureSeries* series = nullptr;
  const reports::SessionValue* today = nullptr;
  const reports::SessionValue* before = nullptr;  ///< null: none
};

/// Key measures of the newest session; nothing of a session before it.
std::vector<Candidate> candidates(const reports::ReportContent& content, std::optional<Hand> hand) {
  std::vector<Candidate> found;
  const std::size_t newest = content.sessions.size() - 1;
  for (const auto& section : content.sections) {
    if (section.hand != hand) continue;
    for (const auto& series : section.series) {
      if ((!series.key && !series.verdict) || series.values.empty()) continue;
      if (series.values.back().session != newest) continue;
      const bool compared = series.values.size() > 1;
      found.push_back({&section, &series, &series.values.back(),
                       compared ? &series.values[series.values.size() - 2] : nullptr});
    }
  }
  return found;
}

QString value_words(const reports::MeasureSeries& series, const reports::SessionValue* value) {
  if (value == nullptr) return {};
  Measure measure;
  measure.name = series.name;
  measure.channel = series.channel;
  measure.unit = series.unit;
  measure.value = value->mean;
  return measure_value(measure);
}

ClosingRow row_of(const Candidate& candidate) {
  const reports::MeasureSeries& series = *candidate.series;
  Measure measure;
  measure.name = series.name;
  measure.channel = series.channel;
  return {QObject::tr("%1: %2").arg(translated(candidate.section->task), measure_title(measure)),
          value_words(series, candidate.today), value_words(series, candidate.before),
          series.verdict ? translated(reports::verdict_words(*series.verdict)) : QString()};
}

}  // namespace

Closing closing_of(const reports::ReportContent& content, std::optional<Hand> hand) {
  Closing closing;
  if (content.sessions.empty()) return closing;
  auto found = candidates(content, hand);
  // Of tasks without a primary measure the first key measure of each comes before its others.
  const reports::TaskSection* section = nullptr;
  std::vector<std::pair<int, Candidate>> ranked;
  int place = 0;
  for (const auto& candidate : found) {
    place = candidate.section == section ? place + 1 : 0;
    section = candidate.section;
    ranked.emplace_back(candidate.series->verdict ? -1 : place, candidate);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [rank, candidate] : ranked) {
    if (closing.rows.size() == Closing::kMostRows) break;
    closing.rows.push_back(row_of(candidate));
  }
  for (const auto& line : content.quality)
    if (line.attention)
      closing.doubts << QObject::tr("%1: %2").arg(translated(line.label), translated(line.text));
  if (const auto* main = reports::main_limit(content.limits))
    closing.next = translated(
        "Train next: %1."_text(Known{std::string(reports::training_for(main->component))}));
  return closing;
}

}  // namespace isograsp::gui
