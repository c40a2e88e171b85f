// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences and table rows of a report, equal in PDF and HTML. UTF-8.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"

namespace isograsp::reports {

[[nodiscard]] std::string format_date(const std::string& iso);  ///< "2026-03-12" -> "12 Mar 2026"

/// Label and value pairs under the title.
struct Fact {
  std::string label;
  std::string value;
};
[[nodiscard]] std::vector<Fact> header_facts(const ReportContent& content);

/// "SIMULATED DEVICE", "REPLAYED RECORDING", both, or empty.
[[nodiscard]] std::string watermark(const ReportContent& content);

/// One line per key measure of each task; primary measures first.
struct GlanceRow {
  std::string task;
  std::string hand;
  std::string measure;
  std::string unit;
  std::string baseline;
  std::string baseline_basis;
  std::string last;
  std::string beside;  ///< the other hand, healthy people; empty: neither is known
  std::string change;
  std::string mdc;        ///< "MDC95 −2.1 / +2.9 N"; empty: none
  std::string direction;  ///< "lower is better"
  std::string verdict;
  std::string verdict_basis;  ///< why, or how sure
  bool primary = false;
};
[[nodiscard]] std::vector<GlanceRow> glance_rows(const ReportContent& content);
/// "improved (confirmed)", "not larger than measurement error", "cannot be judged yet".
[[nodiscard]] std::string verdict_words(const ChangeVerdict& verdict);
/// What stands behind it: "two assessments in a row, 12 stable people", or why it cannot be judged.
[[nodiscard]] std::string verdict_basis(const ChangeVerdict& verdict);
/// "MDC95 2.1 N", "MDC95 −2.1 / +2.9 N"; empty: none.
[[nodiscard]] std::string mdc_words(const ChangeJudgement& change, const std::string& unit);
/// What the verdicts mean, who chose their measures; one paragraph each.
[[nodiscard]] std::vector<std::string> verdict_notes(const ReportContent& content);

[[nodiscard]] std::string section_subtitle(const TaskSection& section);
[[nodiscard]] std::string series_title(const MeasureSeries& series);
[[nodiscard]] std::string series_subtitle(const MeasureSeries& series);  ///< unit and direction
[[nodiscard]] std::string last_trial_title(const TaskSection& section,
                                           const ReportContent& content);
/// "Best trial · session 3, 12 Mar 2026, trial 5 · 4.12 %"
[[nodiscard]] std::string extreme_title(const TaskSection& section, const DrawnTrial& trial,
                                        bool best, const ReportContent& content);
[[nodiscard]] std::string fingers_note();  ///< how finger forces and the way are read together
/// Every measure of the last trial that is not in a trend, in one line; empty: none.
[[nodiscard]] std::string last_trial_results(const TaskSection& section);

/// A series as a table: one row per session.
[[nodiscard]] std::vector<std::array<std::string, 4>> series_table(const MeasureSeries& series,
                                                                   const ReportContent& content);

/// What the marks of a trend mean.
[[nodiscard]] std::string trend_key(const ReportContent& content);
[[nodiscard]] std::string footer(const ReportContent& content);
[[nodiscard]] std::string nothing_yet();  ///< a patient without completed trials

}  // namespace isograsp::reports
