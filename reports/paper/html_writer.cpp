// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/html_writer.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "hand/arm_columns.hpp"
#include "hand/two_hands_columns.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/paper/html_parts.hpp"
#include "reports/paper/panel.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/facts/measure_words.hpp"

namespace isograsp::reports {

struct HtmlReport::Parts {
  Parts(ReportContent content, const Language& language)
      : content_(std::move(content)), say_(language) {}

  void head() {
    out_ += html_head(furniture_of(content_, say_.language()));
    if (content_.sections.empty()) out_ += "<p>" + html(nothing_yet()) + "</p>\n";
  }

  /// In the language of the report.
  [[nodiscard]] QString html(const Text& text) const { return escaped(say_(text)); }
  [[nodiscard]] std::vector<QString> html(const std::vector<Words>& all) const {
    std::vector<QString> said;
    for (const Words words : all) said.push_back(html(words));
    return said;
  }

  void table(const QString& caption, const std::vector<QString>& heads,
             const std::vector<std::vector<QString>>& rows) {
    out_ += html_table(caption, heads, rows);
  }
  void panels(const std::vector<Panel>& panels) {
    for (const auto& panel : panels) out_ += html_section(panel);
  }

  void glance() {
    const auto rows = glance_rows(content_, say_.language());
    if (rows.empty()) return;
    out_ += "<section><h2>" + html("At a glance"_text) + "</h2>\n";
    std::vector<std::vector<QString>> cells;
    const auto small = [](const std::string& text) {
      return text.empty() ? QString() : "<br><small>" + escaped(text) + "</small>";
    };
    for (const auto& row : rows)
      cells.push_back(
          {escaped(row.task) + small(row.hand), escaped(row.measure) + small(row.direction),
           escaped(row.baseline) + small(row.baseline_basis), escaped(row.last) + small(row.beside),
           escaped(row.change) + small(row.mdc),
           (row.primary ? "<strong>" + escaped(row.verdict) + "</strong>" : escaped(row.verdict)) +
               small(row.verdict_basis)});
    table(html("Key measures"_text),
          html({"Task"_text, "Measure"_text, "Baseline"_text, "Last"_text, "Change"_text,
                "Verdict"_text}),
          cells);
    for (const auto& note : verdict_notes(content_))
      out_ += "<p class=\"quiet\">" + html(note) + "</p>";
    out_ += "</section>\n";
  }

  void quality() {
    if (content_.quality.empty() || content_.sessions.empty()) return;
    const auto& last = content_.sessions.back();
    out_ += "<section class=\"quality\"><h2>" + html("Was the last measurement valid?"_text) +
            "</h2>\n<dl>\n<dt>" + html("Session"_text) + "</dt><dd>" + html(session_words(last)) +
            "</dd>\n";
    for (const auto& line : content_.quality) {
      const QString mark = line.attention ? " class=\"attention\"" : "";
      out_ += "<dt" + mark + ">" + (line.attention ? "! " : "") + html(line.label) + "</dt><dd" +
              mark + ">" + html(line.text) + "</dd>\n";
    }
    out_ += "</dl></section>\n";
  }

  void add_section(const TaskSection& section) {
    out_ += "<section><h2>" + html(Known{section.task}) + "</h2>\n<p class=\"quiet\">" +
            html(section_subtitle(section)) + "</p>\n<div class=\"trends\">\n";
    for (const auto& series : section.series) add_series(series, section);
    out_ += "</div>\n";
    if (section.last) add_last_trial(section);
    add_extremes(section);
    for (const auto& note : section.notes) out_ += "<p class=\"quiet\">" + html(note) + "</p>\n";
    if (const auto panel = postures_panel(section, say_.language())) out_ += html_section(*panel);
    out_ += "</section>\n";
  }

  void add_series(const MeasureSeries& series, const TaskSection& section) {
    const auto title = say_(series_title(series));
    out_ += "<figure><h3>" + escaped(title) + "</h3><p class=\"quiet\">" +
            html(series_subtitle(series)) + "</p>\n";
    if (!series.trend.empty())
      out_ += "<p class=\"quiet\">" + html("Trend: %1"_text(series.trend)) + "</p>\n";
    out_ += svg_of(
        trend_plot(series, section, content_, QSizeF(210, 120), kHtmlUnit, say_.language()), title,
        say_("Values over the sessions; the table beside holds the same numbers."_text));
    std::vector<std::vector<QString>> rows;
    for (const auto& row : series_table(series, content_, say_.language())) {
      rows.emplace_back();
      for (const auto& cell : row) rows.back().push_back(escaped(cell));
    }
    const auto unit = html(tasks::unit_words(tasks::printed_unit(series.unit).text));
    table(escaped(title) + (unit.isEmpty() ? "" : " [" + unit + "]"),
          html({"Session"_text, "Date"_text, "Mean"_text, "Trials"_text}), rows);
    out_ += "</figure>\n";
  }

  void add_last_trial(const TaskSection& section) {
    const auto title = say_(last_trial_title(section, content_));
    out_ += "<h3>" + escaped(title) + "</h3>\n";
    if (!section.last->problem.empty()) {
      out_ += "<p>" + html(section.last->problem) + "</p>\n";
      return;
    }
    out_ += "<div class=\"trial\"><figure>\n";
    const bool path = has_path(section);
    out_ += svg_of(
        overlay_plot(section, *section.last,
                     path ? QSizeF(420, 230)
                          : QSizeF(640, is_of_arm(section) || moves_object(section) ? 230 : 160),
                     kHtmlUnit, say_.language()),
        title, say_(describe_overlay(section)));
    out_ += "</figure>\n";
    if (path)
      out_ += "<figure>\n" +
              svg_of(path_plot(section, QSizeF(215, 230), kHtmlUnit, say_.language()),
                     say_("Path in the plane"_text),
                     say_("The way of the object in the plane, with the targets as numbered "
                          "circles."_text)) +
              "</figure>\n";
    out_ += "</div>\n";
    if (has_fingers(section))
      out_ += "<figure>\n" +
              svg_of(fingers_plot(section, QSizeF(640, 220), kHtmlUnit, say_.language()),
                     say_("Forces of the fingers"_text), say_(fingers_note())) +
              "</figure>\n<p class=\"quiet\">" + html(fingers_note()) + "</p>\n";
    if (const auto results = last_trial_results(section); !results.empty())
      out_ += "<p class=\"quiet\">" + html(results) + "</p>\n";
    signal_table(section, path);
  }

  void add_extremes(const TaskSection& section) {
    if (!section.best || !section.worst) return;
    out_ += "<div class=\"trial\">\n";
    for (const auto* trial : {&*section.best, &*section.worst}) {
      const auto title = say_(extreme_title(section, *trial, trial == &*section.best, content_));
      out_ += "<figure><h3>" + escaped(title) + "</h3>\n";
      if (trial->problem.empty())
        out_ += svg_of(overlay_plot(section, *trial, QSizeF(310, 130), kHtmlUnit, say_.language()),
                       title, say_("Force of the patient over the target of this trial."_text));
      else
        out_ += "<p>" + html(trial->problem) + "</p>";
      out_ += "</figure>\n";
    }
    out_ += "</div>\n";
  }

  /// One row per second: enough to follow the plot without seeing it.
  void signal_table(const TaskSection& section, bool path) {
    const Signals& curves = section.last->curves;
    struct Shown {
      const Column& column;
      Words head;
    };
    const std::vector<Shown> wanted =
        is_of_two_hands(section) && lifts_object(curves)
            ? std::vector<Shown>{{columns::target_position[1], "Target height"_text},
                                 {columns::hand_end.left[1], "Left end"_text},
                                 {columns::hand_end.right[1], "Right end"_text},
                                 {columns::actual_angle_rad, "Tilt"_text},
                                 {columns::hand_push.left[1], "Push up, left hand"_text},
                                 {columns::hand_push.right[1], "Push up, right hand"_text}}
        : is_of_two_hands(section) && carries_object(curves)
            ? std::vector<Shown>{{columns::target_position[0], "Target x"_text},
                                 {columns::actual_position[0], "Object x"_text},
                                 {columns::target_position[1], "Target y"_text},
                                 {columns::actual_position[1], "Object y"_text},
                                 {columns::hand_squeeze_N.left, "Squeeze, left hand"_text},
                                 {columns::hand_squeeze_N.right, "Squeeze, right hand"_text}}
        : path ? std::vector<Shown>{{columns::target_position[0], "Target x"_text},
                                    {columns::actual_position[0], "Patient x"_text},
                                    {columns::target_position[1], "Target y"_text},
                                    {columns::actual_position[1], "Patient y"_text},
                                    {columns::target_angle_rad, "Target angle"_text},
                                    {columns::actual_angle_rad, "Patient angle"_text}}
        : is_of_arm(section)
            ? std::vector<Shown>{{columns::link_angle[0][2], "Forearm"_text},
                                 {columns::link_angle[1][0], "Wrist, first angle"_text},
                                 {columns::link_angle[1][1], "Wrist, second angle"_text}}
        : is_of_two_hands(section)
            ? std::vector<Shown>{{columns::target_sum_force_N, "Target of both"_text},
                                 {columns::hand_grip.left, "Left hand"_text},
                                 {columns::hand_grip.right, "Right hand"_text}}
            : std::vector<Shown>{{columns::target_force_N, "Target force"_text},
                                 {columns::actual_force_N, "Patient force"_text}};
    std::vector<Shown> shown;
    std::vector<QString> heads{html("Time [s]"_text)};
    for (const auto& one : wanted) {
      const auto column = curves.column(one.column);
      if (std::none_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); }))
        continue;
      shown.push_back(one);
      heads.push_back(html(one.head) + " [" +
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
        rows.back().push_back(std::isfinite(value) ? escaped(say_(value_number(value, unit)))
                                                   : QString(kNoValue));
      }
    }
    out_ += "<details><summary>" + html("The last trial as a table, second by second"_text) +
            "</summary>\n";
    table(html("Last trial"_text), heads, rows);
    out_ += "</details>\n";
  }

  void end() {
    if (!content_.sections.empty())
      out_ += "<p class=\"quiet\">" + html(trend_key(content_)) + "</p>\n";
    panels(panels_below(content_, say_.language()));
    out_ += html_end(furniture_of(content_, say_.language()));
  }

  const ReportContent content_;
  const Speaker say_;
  QString out_;
  std::size_t done_ = 0;
};

HtmlReport::HtmlReport(ReportContent content, const Language& language)
    : parts_(std::make_unique<Parts>(std::move(content), language)) {}
HtmlReport::~HtmlReport() = default;

int HtmlReport::steps() const noexcept {
  return static_cast<int>(parts_->content_.sections.size()) + 1;
}
int HtmlReport::steps_done() const noexcept {
  return static_cast<int>(parts_->done_);
}
Text HtmlReport::words() const {
  return "part %1 of %2"_text(std::min(steps_done() + 1, steps()), steps());
}

void HtmlReport::paint_next() {
  assert(!complete());
  Parts& p = *parts_;
  if (p.done_ == 0) {
    p.head();
    p.panels(panels_above(p.content_, p.say_.language()));
    p.glance();
    p.quality();
    p.panels(panels_between(p.content_, p.say_.language()));
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
                        const Progress& progress, const Language& language) {
  HtmlReport report(content, language);
  return write_all(report, path, progress);
}

}  // namespace isograsp::reports
