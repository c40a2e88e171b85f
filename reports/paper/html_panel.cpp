// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/html_parts.hpp"

namespace isograsp::reports {

namespace {

/// What stands behind a line break is small.
QString html_cell(const std::string& text) {
  const auto cut = text.find('\n');
  if (cut == std::string::npos) return escaped(text);
  return escaped(text.substr(0, cut)) + "<br><small>" + escaped(text.substr(cut + 1)) + "</small>";
}

QString table_of(const PanelTable& panel) {
  std::vector<QString> heads;
  for (const auto& head : panel.heads) heads.push_back(escaped(head));
  std::vector<std::vector<QString>> rows;
  for (const auto& row : panel.rows) {
    rows.emplace_back();
    for (const auto& text : row) rows.back().push_back(html_cell(text));
  }
  return html_table(escaped(panel.caption), heads, rows);
}

}  // namespace

QString html_section(const Panel& panel) {
  QString out = panel.large_print ? "<section class=\"large\">" : "<section>";
  const QString heading = panel.of_task ? "h3" : "h2";
  out += "<" + heading + ">" + escaped(panel.heading) + "</" + heading + ">\n";
  for (const auto& line : panel.lines) out += "<p>" + escaped(line) + "</p>\n";
  if (!panel.plots.empty()) out += "<div class=\"plots\">\n";
  for (const auto& plot : panel.plots) {
    constexpr double kPageWidth = 640.0;  // [points]
    const QSizeF size(plot.share * kPageWidth, plot.height * (plot.share < 1.0 ? 1.3 : 1.0));
    out += "<figure><h3>" + escaped(plot.title) + "</h3>\n" +
           svg_of(plot.make(size, kHtmlUnit), plot.title, plot.description) + "</figure>\n";
  }
  if (!panel.plots.empty()) out += "</div>\n";
  if (panel.table) out += table_of(*panel.table);
  if (!panel.blanks.empty()) out += "<div class=\"blanks\">\n";
  for (const auto& blank : panel.blanks) out += "<p>" + escaped(blank) + "</p>\n";
  if (!panel.blanks.empty()) out += "</div>\n";
  for (const auto& note : panel.notes) out += "<p class=\"quiet\">" + escaped(note) + "</p>\n";
  return out + "</section>\n";
}

}  // namespace isograsp::reports
