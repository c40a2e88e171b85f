// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences and table rows of a report, equal in PDF and HTML. UTF-8.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/report_content.hpp"

namespace isograsp {

[[nodiscard]] std::string format_date(const std::string& iso);  ///< "2026-03-12" -> "12 Mar 2026"

/// Label and value pairs under the title.
struct Fact {
  std::string label;
  std::string value;
};
[[nodiscard]] std::vector<Fact> header_facts(const ReportContent& content);

/// "SIMULATED DEVICE", "REPLAYED RECORDING", both, or empty.
[[nodiscard]] std::string watermark(const ReportContent& content);

/// One line per key measure of each task.
struct GlanceRow {
  std::string task;
  std::string hand;
  std::string measure;
  std::string unit;
  std::string baseline;
  std::string baseline_basis;
  std::string last;
  std::string change;
  std::string direction;  ///< "lower is better"
  std::string verdict;
};
[[nodiscard]] std::vector<GlanceRow> glance_rows(const ReportContent& content);
[[nodiscard]] std::string verdict_note();

[[nodiscard]] std::string section_subtitle(const TaskSection& section);
[[nodiscard]] std::string series_title(const MeasureSeries& series);
[[nodiscard]] std::string series_subtitle(const MeasureSeries& series);  ///< unit and direction
[[nodiscard]] std::string last_trial_title(const TaskSection& section,
                                           const ReportContent& content);
/// Every measure of the last trial that is not in a trend, in one line; empty: none.
[[nodiscard]] std::string last_trial_results(const TaskSection& section);

/// A series as a table: one row per session.
[[nodiscard]] std::vector<std::array<std::string, 4>> series_table(const MeasureSeries& series,
                                                                   const ReportContent& content);

/// What the marks of a trend mean.
[[nodiscard]] std::string trend_key();
[[nodiscard]] std::string footer(const ReportContent& content);
[[nodiscard]] std::string nothing_yet();  ///< a patient without completed trials

}  // namespace isograsp
