// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/html_parts.hpp"

#include <QBuffer>
#include <QSvgGenerator>
#include <cmath>

#include "reports/paper/palette.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

namespace {

constexpr const char* kStyle =
    R"(body { font: 15px/1.45 "DejaVu Sans", system-ui, sans-serif; color: %INK%; background: #fff;
  max-width: 920px; margin: 0 auto; padding: 32px 24px; }
h1 { font-size: 36px; margin: 0 0 12px; } h1.long { font-size: 24px; padding-right: 220px; }
 h2 { font-size: 20px; margin: 40px 0 4px; }
h3 { font-size: 15px; margin: 20px 0 0; } p { margin: 4px 0; }
.quiet, small, caption { color: %QUIET%; font-size: 13px; }
header { border-bottom: 1px solid %LINE%; padding-bottom: 14px; position: relative; }
.badge { position: absolute; top: 0; right: 0; border: 1.5px solid %INK%; padding: 4px 10px;
  font-weight: bold; font-size: 13px; }
.facts { display: flex; flex-wrap: wrap; gap: 28px; border-top: 1.5px solid %INK%; margin: 0;
  padding-top: 12px; }
.facts dt { color: %QUIET%; font-size: 13px; } .facts dd { margin: 0; font-weight: bold; }
table { border-collapse: collapse; width: 100%; margin: 8px 0; font-variant-numeric: tabular-nums; }
caption { text-align: left; } th { text-align: left; font-weight: normal; }
thead th { color: %QUIET%; font-size: 13px; border-bottom: 1px solid %QUIET%; }
th, td { padding: 5px 10px 5px 0; border-bottom: 1px solid %LINE%; vertical-align: top; }
.quality dl { border: 1px solid %LINE%; padding: 12px 16px; margin: 8px 0; display: grid;
  grid-template-columns: 9em 1fr; gap: 4px 12px; }
.quality dt { color: %QUIET%; } .quality dd { margin: 0; }
.quality .attention { font-weight: bold; color: %INK%; }
figure { margin: 0; } svg { width: 100%; height: auto; display: block; }
td.number, th.number { text-align: right; } figure.boxes { margin: 16px 0; }
.trends { display: grid; grid-template-columns: repeat(auto-fill, minmax(270px, 1fr)); gap: 8px 24px; }
.trends table { font-size: 13px; }
.plots { display: flex; flex-wrap: wrap; gap: 8px 24px; } .plots figure { flex: 1 1 180px; }
.blanks { display: flex; gap: 24px; margin-top: 64px; }
.blanks p { flex: 1; border-top: 1px solid %INK%; color: %QUIET%; font-size: 13px; }
.large { font-size: 30px; break-before: page; border-top: 1px solid %LINE%; margin-top: 48px; }
.large h2 { font-size: 52px; } .large h3 { font-size: 30px; } .large p { margin: 16px 0; }
.trial { display: flex; flex-wrap: wrap; gap: 24px; align-items: flex-start; }
.trial figure { flex: 2 1 auto; min-width: 260px; } .trial figure + figure { flex: 1 1 auto; }
details { margin: 8px 0; } summary { cursor: pointer; }
footer { border-top: 1px solid %LINE%; margin-top: 40px; padding-top: 8px; color: %QUIET%;
  font-size: 13px; }
.watermark { position: fixed; top: 45%; left: 0; right: 0; text-align: center; font-weight: bold;
  font-size: min(9vw, 84px); color: rgba(0, 0, 0, 0.06); transform: rotate(-35deg);
  pointer-events: none; white-space: nowrap; }
details { overflow-x: auto; }
@media (max-width: 640px) {
  body { padding: 16px 12px; overflow-wrap: anywhere; }
  h1, h1.long { font-size: 26px; padding-right: 0; }
  .badge { position: static; display: inline-block; margin: 0 0 12px; }
  .facts { gap: 8px 24px; }
  .quality dl { grid-template-columns: 1fr; gap: 0; } .quality dd { margin-bottom: 8px; }
  .trends { grid-template-columns: 1fr; }
  .trial figure { overflow-x: auto; } .trial figure:first-child svg { min-width: 560px; }
  .large { font-size: 22px; } .large h2 { font-size: 34px; } .large h3 { font-size: 22px; }
  table.cards, .cards caption, .cards tbody, .cards tr { display: block; }
  .cards thead { position: absolute; left: -9999px; }
  .cards tr { border-bottom: 1px solid %QUIET%; padding: 8px 0; }
  .cards th, .cards td, .cards .number { display: flow-root; border: 0; padding: 2px 0 2px 140px;
    text-align: left; }
  .cards [data-head]::before { content: attr(data-head); float: left; width: 130px;
    margin-left: -140px; color: %QUIET%; font-size: 13px; font-weight: normal; }
}
@media print { section { break-inside: avoid; } details { display: none; } }
)";

QString style() {
  return QString(kStyle)
      .replace("%INK%", Palette::ink().name())
      .replace("%QUIET%", Palette::quiet().name())
      .replace("%LINE%", Palette::line().name());
}

/// A report is words, styles and drawings: it loads nothing, runs nothing and sends nothing,
/// whatever stands in the texts of the database.
constexpr const char* kPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; "
    "form-action 'none'";

}  // namespace

QString escaped(const std::string& text) {
  return QString::fromStdString(text).toHtmlEscaped();
}

/// A plot as an <svg> element with role, title and description for screen readers.
QString svg_of(PlotView view, const std::string& title, const std::string& description) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QSize size(static_cast<int>(std::lround(view.px(view.size().width()))),
                   static_cast<int>(std::lround(view.px(view.size().height()))));
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setTitle(escaped(title));  // Qt writes both as they are
  generator.setDescription(escaped(description));
  QCPPainter painter(&generator);
  view.paint(painter);
  painter.end();
  QString svg = QString::fromUtf8(buffer.data());
  svg.remove(0, svg.indexOf("<svg"));
  const QString label = escaped(title + ". " + description);
  return svg.replace(0, 4,
                     QString("<svg role=\"img\" aria-label=\"%1\" style=\"max-width:%2px\"")
                         .arg(label, QString::number(size.width())));
}

QString html_head(const PageFurniture& furniture) {
  const auto title = escaped(furniture.title);
  const auto mark = escaped(furniture.watermark);
  QString out =
      "<!DOCTYPE html>\n<html lang=\"" + escaped(language_code(*furniture.language)) +
      "\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" +
      QString(kPolicy) +
      "\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      escaped(furniture.kind) + " " + title + "</title>\n<style>\n" + style() +
      "</style>\n</head>\n<body>\n";
  if (!mark.isEmpty()) out += "<div class=\"watermark\" aria-hidden=\"true\">" + mark + "</div>\n";
  out += "<header>\n<p class=\"quiet\">IsoGrasp · " + escaped(furniture.kind) + "</p>\n<h1" +
         (furniture.title.size() > kLongTitle ? " class=\"long\"" : "") + ">" + title + "</h1>\n";
  if (!mark.isEmpty()) out += "<p class=\"badge\">" + mark + "</p>\n";
  out += "<dl class=\"facts\">\n";
  for (const auto& fact : furniture.facts)
    out += "<div><dt>" + escaped(fact.label) + "</dt><dd>" + escaped(fact.value) + "</dd></div>\n";
  return out + "</dl>\n</header>\n<main>\n";
}

QString html_end(const PageFurniture& furniture) {
  return "</main>\n<footer>" + escaped(furniture.footer) + "</footer>\n</body>\n</html>\n";
}

QString html_table(const QString& caption, const std::vector<QString>& heads,
                   const std::vector<std::vector<QString>>& rows, std::size_t first_number) {
  const auto kind = [first_number](std::size_t column) {
    return column >= first_number ? " class=\"number\"" : "";
  };
  // Where the screen is narrow the rows of a wide table become blocks, and each cell says its
  // column. With the roles it is still a table for a screen reader.
  constexpr std::size_t kWide = 5;
  const bool wide = heads.size() >= kWide;
  const auto role = [wide](const char* name) {
    return wide ? QString(" role=\"%1\"").arg(name) : QString();
  };
  const auto named = [&](std::size_t column) {
    return wide ? " data-head=\"" + heads[column] + "\"" : QString();
  };
  QString out = (wide ? "<table class=\"cards\" role=\"table\">" : "<table>") +
                ("<caption>" + caption) + "</caption>\n<thead><tr" + role("row") + ">";
  for (std::size_t i = 0; i < heads.size(); ++i)
    out += "<th scope=\"col\"" + role("columnheader") + kind(i) + ">" + heads[i] + "</th>";
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : rows) {
    out += "<tr" + role("row") + "><th scope=\"row\"" + role("rowheader") + named(0) + kind(0) +
           ">" + row.front() + "</th>";
    for (std::size_t i = 1; i < row.size(); ++i)
      out += "<td" + role("cell") + named(i) + kind(i) + ">" + row[i] + "</td>";
    out += "</tr>\n";
  }
  return out + "</tbody></table>\n";
}

}  // namespace isograsp::reports
