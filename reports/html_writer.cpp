// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/html_writer.hpp"

#include <QBuffer>
#include <QSvgGenerator>
#include <algorithm>
#include <cassert>
#include <cmath>

#include <qcustomplot.h>

#include "reports/measure_words.hpp"
#include "reports/plots.hpp"
#include "reports/report_text.hpp"

namespace isograsp {

namespace {

constexpr double kUnit = 4.0 / 3.0;  // CSS pixels per point

QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

/// A plot as an <svg> element that speaks: role, title and description.
QString svg_of(PlotView view, const std::string& title, const std::string& description) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QSize size(static_cast<int>(std::lround(view.px(view.size().width()))),
                   static_cast<int>(std::lround(view.px(view.size().height()))));
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(QString::fromStdString(title));
  generator.setDescription(QString::fromStdString(description));
  QCPPainter painter(&generator);
  view.paint(painter);
  painter.end();
  QString svg = QString::fromUtf8(buffer.data());
  svg.remove(0, svg.indexOf("<svg"));
  const QString label = escaped(title + ". " + description);
  return svg.replace(0, 4,
                     QString("<svg role=\"img\" aria-label=\"%1\" style=\"max-width:%2px\"")
                         .arg(label)
                         .arg(size.width()));
}

}  // namespace

struct HtmlReport::Parts {
  explicit Parts(ReportContent content) : content_(std::move(content)) {}

  void head() {
    const auto code = escaped(content_.code);
    out_ +=
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
        "Progress report " +
        code + "</title>\n<style>\n" + kStyle + "</style>\n</head>\n<body>\n";
    const auto mark = escaped(watermark(content_));
    if (!mark.isEmpty())
      out_ += "<div class=\"watermark\" aria-hidden=\"true\">" + mark + "</div>\n";
    out_ += "<header>\n<p class=\"quiet\">IsoGrasp · Progress report</p>\n<h1>" + code + "</h1>\n";
    if (!mark.isEmpty()) out_ += "<p class=\"badge\">" + mark + "</p>\n";
    out_ += "<dl class=\"facts\">\n";
    for (const auto& fact : header_facts(content_))
      out_ +=
          "<div><dt>" + escaped(fact.label) + "</dt><dd>" + escaped(fact.value) + "</dd></div>\n";
    out_ += "</dl>\n</header>\n<main>\n";
    if (content_.sections.empty()) out_ += "<p>" + escaped(nothing_yet()) + "</p>\n";
  }

  void table(const QString& caption, const std::vector<QString>& heads,
             const std::vector<std::vector<QString>>& rows) {
    out_ += "<table><caption>" + caption + "</caption>\n<thead><tr>";
    for (const auto& title : heads) out_ += "<th scope=\"col\">" + title + "</th>";
    out_ += "</tr></thead>\n<tbody>\n";
    for (const auto& row : rows) {
      out_ += "<tr><th scope=\"row\">" + row.front() + "</th>";
      for (std::size_t i = 1; i < row.size(); ++i) out_ += "<td>" + row[i] + "</td>";
      out_ += "</tr>\n";
    }
    out_ += "</tbody></table>\n";
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
      cells.push_back({escaped(row.task) + small(row.hand + " hand"),
                       escaped(row.measure) + small(row.direction),
                       escaped(row.baseline) + small(row.baseline_basis), escaped(row.last),
                       escaped(row.change), escaped(row.verdict)});
    table("Key measures", {"Task", "Measure", "Baseline", "Last", "Change", "Verdict"}, cells);
    out_ += "<p class=\"quiet\">" + escaped(verdict_note()) + "</p></section>\n";
  }

  void quality() {
    if (content_.quality.empty()) return;
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
    for (const auto& note : section.notes) out_ += "<p class=\"quiet\">" + escaped(note) + "</p>\n";
    out_ += "</section>\n";
  }

  void add_series(const MeasureSeries& series, const TaskSection& section) {
    const auto title = series_title(series);
    out_ += "<figure><h3>" + escaped(title) + "</h3><p class=\"quiet\">" +
            escaped(series_subtitle(series)) + "</p>\n";
    out_ += svg_of(trend_plot(series, section, content_, QSizeF(210, 120), kUnit), title,
                   "Values over the sessions; the table beside holds the same numbers.");
    std::vector<std::vector<QString>> rows;
    for (const auto& row : series_table(series, content_)) {
      rows.emplace_back();
      for (const auto& cell : row) rows.back().push_back(escaped(cell));
    }
    const auto unit = escaped(printed_unit(series.unit).text);
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
    out_ += svg_of(overlay_plot(section, path ? QSizeF(420, 230) : QSizeF(640, 160), kUnit), title,
                   describe_overlay(section));
    out_ += "</figure>\n";
    if (path)
      out_ += "<figure>\n" +
              svg_of(path_plot(section, QSizeF(215, 230), kUnit), "Path in the plane",
                     "The way of the object in the plane, with the targets as numbered circles.") +
              "</figure>\n";
    out_ += "</div>\n";
    if (const auto results = last_trial_results(section); !results.empty())
      out_ += "<p class=\"quiet\">" + escaped(results) + "</p>\n";
    signal_table(section, path);
  }

  /// One row per second: enough to follow the plot without seeing it.
  void signal_table(const TaskSection& section, bool path) {
    const Signals& curves = section.last->curves;
    std::vector<std::string> columns;
    const std::vector<std::string> wanted =
        path ? std::vector<std::string>{"x_m", "y_m", "angle_rad"}
             : std::vector<std::string>{"force_N"};
    std::vector<QString> heads{"Time [s]"};
    for (const auto& name : wanted)
      for (const char* side : {"target_", "actual_"}) {
        const auto column = curves.column(side + name);
        if (std::none_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); }))
          continue;
        columns.push_back(side + name);
        const auto cut = name.rfind('_');
        const auto unit = name.substr(cut + 1);
        heads.push_back(QString(side == std::string("target_") ? "Target " : "Patient ") +
                        escaped(name.substr(0, cut)) + " [" + escaped(printed_unit(unit).text) +
                        "]");
      }
    std::vector<std::vector<QString>> rows;
    const auto t_s = curves.column("t_s");
    double next_s = 0.0;
    constexpr double kHalfFrame = 1e-6;
    for (std::size_t row = 0; row < t_s.size(); ++row) {
      const double elapsed_s = t_s[row] - t_s.front();
      if (elapsed_s < next_s - kHalfFrame) continue;
      next_s += 1.0;
      rows.push_back({QString::number(std::lround(elapsed_s))});
      for (const auto& name : columns) {
        const double value = curves.column(name)[row];
        rows.back().push_back(std::isfinite(value)
                                  ? escaped(format_value(value, name.substr(name.rfind('_') + 1)))
                                  : QString("–"));
      }
    }
    out_ += "<details><summary>The last trial as a table, second by second</summary>\n";
    table("Last trial", heads, rows);
    out_ += "</details>\n";
  }

  void end() {
    if (!content_.sections.empty()) out_ += "<p class=\"quiet\">" + escaped(trend_key()) + "</p>\n";
    out_ += "</main>\n<footer>" + escaped(footer(content_)) + "</footer>\n</body>\n</html>\n";
  }

  static const QString kStyle;
  const ReportContent content_;
  QString out_;
  std::size_t done_ = 0;
};

const QString HtmlReport::Parts::kStyle =
    R"(body { font: 15px/1.45 "DejaVu Sans", system-ui, sans-serif; color: #22262b; background: #fff;
  max-width: 920px; margin: 0 auto; padding: 32px 24px; }
h1 { font-size: 36px; margin: 0 0 12px; } h2 { font-size: 20px; margin: 40px 0 4px; }
h3 { font-size: 15px; margin: 20px 0 0; } p { margin: 4px 0; }
.quiet, small, caption { color: #5f666e; font-size: 13px; }
header { border-bottom: 1px solid #d5d9dd; padding-bottom: 14px; position: relative; }
.badge { position: absolute; top: 0; right: 0; border: 1.5px solid #22262b; padding: 4px 10px;
  font-weight: bold; font-size: 13px; }
.facts { display: flex; flex-wrap: wrap; gap: 28px; border-top: 1.5px solid #22262b; margin: 0;
  padding-top: 12px; }
.facts dt { color: #5f666e; font-size: 13px; } .facts dd { margin: 0; font-weight: bold; }
table { border-collapse: collapse; width: 100%; margin: 8px 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; } th { text-align: left; font-weight: normal; }
thead th { color: #5f666e; font-size: 13px; border-bottom: 1px solid #5f666e; }
th, td { padding: 5px 10px 5px 0; border-bottom: 1px solid #d5d9dd; vertical-align: top; }
.quality dl { border: 1px solid #d5d9dd; padding: 12px 16px; margin: 8px 0; display: grid;
  grid-template-columns: 9em 1fr; gap: 4px 12px; }
.quality dt { color: #5f666e; } .quality dd { margin: 0; }
.quality .attention { font-weight: bold; color: #22262b; }
figure { margin: 0; } svg { width: 100%; height: auto; display: block; }
.trends { display: grid; grid-template-columns: repeat(auto-fill, minmax(270px, 1fr)); gap: 8px 24px; }
.trends table { font-size: 13px; }
.trial { display: flex; flex-wrap: wrap; gap: 24px; align-items: flex-start; }
.trial figure { flex: 2 1 auto; min-width: 260px; } .trial figure + figure { flex: 1 1 auto; }
details { margin: 8px 0; } summary { cursor: pointer; }
footer { border-top: 1px solid #d5d9dd; margin-top: 40px; padding-top: 8px; color: #5f666e;
  font-size: 13px; }
.watermark { position: fixed; top: 45%; left: 0; right: 0; text-align: center; font-weight: bold;
  font-size: min(9vw, 84px); color: rgba(0, 0, 0, 0.06); transform: rotate(-35deg);
  pointer-events: none; white-space: nowrap; }
@media print { section { break-inside: avoid; } details { display: none; } }
)";

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
    p.glance();
    p.quality();
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

}  // namespace isograsp
