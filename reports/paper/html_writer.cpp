// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/html_writer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "hand/columns.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/html_panel.hpp"
#include "reports/paper/html_parts.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

struct HtmlReport::Parts {
  explicit Parts(ReportContent content) : content_(std::move(content)) {}

  void head() {
    out_ += html_head(furniture_of(content_));
    if (content_.sections.empty()) out_ += "<p>" + escaped(nothing_yet()) + "</p>\n";
  }

  void table(const QString& caption, const std::vector<QString>& heads,
             const std::vector<std::vector<QString>>& rows) {
    out_ += html_table(caption, heads, rows);
  }
  void panels(const std::vector<Panel>& panels) {
    for (const auto& panel : panels) out_ += html_section(panel);
  }

  void glance() {
    const auto rows = glance_rows(content_);
    if (rows.empty()) return;
    out_ += "<section><h2>At a glance</h2>\n";
    std::vector<std::vector<QString>> cells;
    const auto small = [](const std::string& text) {
      return text.empty() ? QString() : "<br><small>" + escaped(text) + "</small>";
    };
    for (const auto& row : rows)
      cells.push_back(
          {escaped(row.task) + small(row.hand + " hand"),
           escaped(row.measure) + small(row.direction),
           escaped(row.baseline) + small(row.baseline_basis), escaped(row.last) + small(row.beside),
           escaped(row.change) + small(row.mdc),
           (row.primary ? "<strong>" + escaped(row.verdict) + "</strong>" : escaped(row.verdict)) +
               small(row.verdict_basis)});
    table("Key measures", {"Task", "Measure", "Baseline", "Last", "Change", "Verdict"}, cells);
    for (const auto& note : verdict_notes(content_))
      out_ += "<p class=\"quiet\">" + escaped(note) + "</p>";
    out_ += "</section>\n";
  }

  void quality() {
    if (content_.quality.empty() || content_.sessions.empty()) return;
    const auto& last = content_.sessions.back();
    out_ += "<section class=\"quality\"><h2>Was the last measurement valid?</h2>\n<dl>\n";
    out_ += QString("<dt>Session</dt><dd>%1, %2, %3 hand, %4</dd>\n")
                .arg(last.number)
                .arg(escaped(format_date(last.date)), escaped(std::string(name_of(last.hand))),
                     escaped(last.device));
    for (const auto& line : content_.quality) {
      const QString mark = line.attention ? " class=\"attention\"" : "";
      out_ += "<dt" + mark + ">" + (line.attention ? "! " : "") + escaped(line.label) + "</dt><dd" +
              mark + ">" + escaped(line.text) + "</dd>\n";
    }
    out_ += "</dl></section>\n";
  }

  void add_section(const TaskSection& section) {
    out_ += "<section><h2>" + escaped(section.task) + "</h2>\n<p class=\"quiet\">" +
            escaped(section_subtitle(section)) + "</p>\n<div class=\"trends\">\n";
    for (const auto& series : section.series) add_series(series, section);
    out_ += "</div>\n";
    if (section.last) add_last_trial(section);
    add_extremes(section);
    for (const auto& note : section.notes) out_ += "<p class=\"quiet\">" + escaped(note) + "</p>\n";
    out_ += "</section>\n";
  }

  void add_series(const MeasureSeries& series, const TaskSection& section) {
    const auto title = series_title(series);
    out_ += "<figure><h3>" + escaped(title) + "</h3><p class=\"quiet\">" +
            escaped(series_subtitle(series)) + "</p>\n";
    if (!series.trend.empty())
      out_ += "<p class=\"quiet\">Trend: " + escaped(series.trend) + "</p>\n";
    out_ += svg_of(trend_plot(series, section, content_, QSizeF(210, 120), kHtmlUnit), title,
                   "Values over the sessions; the table beside holds the same numbers.");
    std::vector<std::vector<QString>> rows;
    for (const auto& row : series_table(series, content_)) {
      rows.emplace_back();
      for (const auto& cell : row) rows.back().push_back(escaped(cell));
    }
    const auto unit = escaped(tasks::printed_unit(series.unit).text);
    table(escaped(title) + (unit.isEmpty() ? "" : " [" + unit + "]"),
          {"Session", "Date", "Mean", "Trials"}, rows);
    out_ += "</figure>\n";
  }

  void add_last_trial(const TaskSection& section) {
    const auto title = last_trial_title(section, content_);
    out_ += "<h3>" + escaped(title) + "</h3>\n";
    if (!section.last->problem.empty()) {
      out_ += "<p>" + escaped(section.last->problem) + "</p>\n";
      return;
    }
    out_ += "<div class=\"trial\"><figure>\n";
    const bool path = has_path(section);
    out_ += svg_of(
        overlay_plot(section, *section.last, path ? QSizeF(420, 230) : QSizeF(640, 160), kHtmlUnit),
        title, describe_overlay(section));
    out_ += "</figure>\n";
    if (path)
      out_ += "<figure>\n" +
              svg_of(path_plot(section, QSizeF(215, 230), kHtmlUnit), "Path in the plane",
                     "The way of the object in the plane, with the targets as numbered circles.") +
              "</figure>\n";
    out_ += "</div>\n";
    if (has_fingers(section))
      out_ += "<figure>\n" +
              svg_of(fingers_plot(section, QSizeF(640, 220), kHtmlUnit), "Forces of the fingers",
                     fingers_note()) +
              "</figure>\n<p class=\"quiet\">" + escaped(fingers_note()) + "</p>\n";
    if (const auto results = last_trial_results(section); !results.empty())
      out_ += "<p class=\"quiet\">" + escaped(results) + "</p>\n";
    signal_table(section, path);
  }

  void add_extremes(const TaskSection& section) {
    if (!section.best || !section.worst) return;
    out_ += "<div class=\"trial\">\n";
    for (const auto* trial : {&*section.best, &*section.worst}) {
      const auto title = extreme_title(section, *trial, trial == &*section.best, content_);
      out_ += "<figure><h3>" + escaped(title) + "</h3>\n";
      if (trial->problem.empty())
        out_ += svg_of(overlay_plot(section, *trial, QSizeF(310, 130), kHtmlUnit), title,
                       "Force of the patient over the target of this trial.");
      else
        out_ += "<p>" + escaped(trial->problem) + "</p>";
      out_ += "</figure>\n";
    }
    out_ += "</div>\n";
  }

  /// One row per second: enough to follow the plot without seeing it.
  void signal_table(const TaskSection& section, bool path) {
    const Signals& curves = section.last->curves;
    struct Shown {
      const Column& column;
      const char* head;
    };
    const std::vector<Shown> wanted =
        path ? std::vector<Shown>{{columns::target_position[0], "Target x"},
                                  {columns::actual_position[0], "Patient x"},
                                  {columns::target_position[1], "Target y"},
                                  {columns::actual_position[1], "Patient y"},
                                  {columns::target_angle_rad, "Target angle"},
                                  {columns::actual_angle_rad, "Patient angle"}}
             : std::vector<Shown>{{columns::target_force_N, "Target force"},
                                  {columns::actual_force_N, "Patient force"}};
    std::vector<Shown> shown;
    std::vector<QString> heads{"Time [s]"};
    for (const auto& one : wanted) {
      const auto column = curves.column(one.column);
      if (std::none_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); }))
        continue;
      shown.push_back(one);
      heads.push_back(QString(one.head) + " [" +
                      escaped(tasks::printed_unit(std::string(unit_of(one.column))).text) + "]");
    }
    std::vector<std::vector<QString>> rows;
    const auto t_s = curves.column(columns::t_s);
    double next_s = 0.0;
    constexpr double kHalfFrame = 1e-6;
    for (std::size_t row = 0; row < t_s.size(); ++row) {
      const double elapsed_s = t_s[row] - t_s.front();
      if (elapsed_s < next_s - kHalfFrame) continue;
      next_s += 1.0;
      rows.push_back({QString::number(std::lround(elapsed_s))});
      for (const auto& one : shown) {
        const double value = curves.column(one.column)[row];
        const std::string unit(unit_of(one.column));
        rows.back().push_back(std::isfinite(value) ? escaped(tasks::format_value(value, unit))
                                                   : QString("–"));
      }
    }
    out_ += "<details><summary>The last trial as a table, second by second</summary>\n";
    table("Last trial", heads, rows);
    out_ += "</details>\n";
  }

  void end() {
    if (!content_.sections.empty())
      out_ += "<p class=\"quiet\">" + escaped(trend_key(content_)) + "</p>\n";
    panels(panels_below(content_));
    out_ += html_end(furniture_of(content_));
  }

  const ReportContent content_;
  QString out_;
  std::size_t done_ = 0;
};

HtmlReport::HtmlReport(ReportContent content)
    : parts_(std::make_unique<Parts>(std::move(content))) {}
HtmlReport::~HtmlReport() = default;

int HtmlReport::steps() const noexcept {
  return static_cast<int>(parts_->content_.sections.size()) + 1;
}
int HtmlReport::steps_done() const noexcept {
  return static_cast<int>(parts_->done_);
}
std::string HtmlReport::words() const {
  return "part " + std::to_string(std::min(steps_done() + 1, steps())) + " of " +
         std::to_string(steps());
}

void HtmlReport::paint_next() {
  assert(!complete());
  Parts& p = *parts_;
  if (p.done_ == 0) {
    p.head();
    p.panels(panels_above(p.content_));
    p.glance();
    p.quality();
    p.panels(panels_between(p.content_));
  } else {
    p.add_section(p.content_.sections[p.done_ - 1]);
  }
  ++p.done_;
  if (complete()) p.end();
}

std::string HtmlReport::take() {
  assert(complete());
  return parts_->out_.toStdString();
}

Result<void> write_html(const ReportContent& content, const std::string& path,
                        const Progress& progress) {
  HtmlReport report(content);
  return write_all(report, path, progress);
}

}  // namespace isograsp::reports
