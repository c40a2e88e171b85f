// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences and table rows of a report, equal in PDF and HTML. Sentences are texts; rows are
// said in the language. UTF-8.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "reports/findings/report_content.hpp"
#include "reports/findings/wording.hpp"

namespace isograsp::reports {

/// Label and value pairs under the title.
struct Fact {
  std::string label;
  std::string value;
};
[[nodiscard]] std::vector<Fact> header_facts(const ReportContent& content,
                                             const Language& language = kEnglish);

/// "SIMULATED DEVICE", "REPLAYED RECORDING", both, or empty.
[[nodiscard]] Text watermark(const ReportContent& content);

/// One line per key measure of each task; primary measures first.
struct GlanceRow {
  std::string task;
  std::string hand;  ///< "right hand"
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
[[nodiscard]] std::vector<GlanceRow> glance_rows(const ReportContent& content,
                                                 const Language& language = kEnglish);
/// "improved (confirmed)", "not larger than measurement error", "cannot be judged yet".
[[nodiscard]] Text verdict_words(const ChangeVerdict& verdict);
/// The reasons for it: "two assessments in a row, 12 stable people", or why it cannot be judged.
[[nodiscard]] Text verdict_basis(const ChangeVerdict& verdict);
/// "MDC95 2.1 N", "MDC95 −2.1 / +2.9 N"; empty: none.
[[nodiscard]] Text mdc_words(const ChangeJudgement& change, const std::string& unit);
/// What the verdicts mean, who chose their measures; one paragraph each.
[[nodiscard]] std::vector<Text> verdict_notes(const ReportContent& content);

/// "3, 12 Mar 2026, right hand, ATI Net F/T …"
[[nodiscard]] Text session_words(const ReportSession& session);
[[nodiscard]] Text section_subtitle(const TaskSection& section);
[[nodiscard]] Text series_title(const MeasureSeries& series);
[[nodiscard]] Text better_words(tasks::Better better);  ///< "lower is better"; empty: neither is
[[nodiscard]] Text series_subtitle(const MeasureSeries& series);  ///< unit and direction
[[nodiscard]] Text last_trial_title(const TaskSection& section, const ReportContent& content);
/// "Best trial · session 3, 12 Mar 2026, trial 5 · 4.12 %"
[[nodiscard]] Text extreme_title(const TaskSection& section, const DrawnTrial& trial, bool best,
                                 const ReportContent& content);
[[nodiscard]] Text fingers_note();  ///< how finger forces and the way are read together
/// Every measure of the last trial that is not in a trend, in one line; empty: none.
[[nodiscard]] Text last_trial_results(const TaskSection& section);

/// A series as a table: one row per session.
[[nodiscard]] std::vector<std::array<std::string, 4>> series_table(
    const MeasureSeries& series, const ReportContent& content, const Language& language = kEnglish);

/// What the marks of a trend mean.
[[nodiscard]] Text trend_key(const ReportContent& content);
[[nodiscard]] Text footer(const ReportContent& content);
[[nodiscard]] Text nothing_yet();  ///< a patient without completed trials

}  // namespace isograsp::reports
