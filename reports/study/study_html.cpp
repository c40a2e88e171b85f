// SPDX-License-Identifier: GPL-3.0-or-later
// A group report as one HTML file: the accessible form.
#include "reports/paper/html_parts.hpp"
#include "reports/study/study_plot.hpp"
#include "reports/study/study_writer.hpp"

namespace isograsp::reports {

namespace {

constexpr QSizeF kPlotSize{640.0, 230.0};  // points

struct HtmlBlocks {
  QString operator()(const StudyHeading& heading) const {
    const char* tag = heading.large ? "h2" : "h3";
    return QString("<%1>").arg(tag) + escaped(heading.text) + QString("</%1>\n").arg(tag);
  }
  QString operator()(const StudyParagraph& paragraph) const {
    return (paragraph.quiet ? "<p class=\"quiet\">" : "<p>") + escaped(paragraph.text) + "</p>\n";
  }
  QString operator()(const StudyTable& table) const {
    std::vector<QString> heads;
    for (const auto& head : table.heads) heads.push_back(escaped(head));
    std::vector<std::vector<QString>> rows;
    for (const auto& row : table.rows) {
      auto& cells = rows.emplace_back();
      for (const auto& cell : row) cells.push_back(escaped(cell));
    }
    return html_table(escaped(table.caption), heads, rows, table.words);
  }
  QString operator()(const StudyPlot& plot) const {
    return "<figure class=\"boxes\"><figcaption><strong>" + escaped(plot.title) +
           "</strong></figcaption>\n" +
           svg_of(study_plot(plot, kPlotSize, kHtmlUnit), plot.title, plot.description) +
           "</figure>\n";
  }
};

}  // namespace

std::string study_html(const StudyReport& report) {
  QString out = html_head(report.furniture);
  for (const auto& block : report.blocks) out += std::visit(HtmlBlocks{}, block);
  return (out + html_end(report.furniture)).toStdString();
}

}  // namespace isograsp::reports
