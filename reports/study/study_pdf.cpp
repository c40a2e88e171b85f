// SPDX-License-Identifier: GPL-3.0-or-later
// A group report as PDF: tables as wide as their words, plots across the page.
#include <QFontMetricsF>
#include <algorithm>
#include <numeric>

#include "reports/paper/pdf_content.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "reports/paper/plotting.hpp"
#include "reports/study/study_plot.hpp"
#include "reports/study/study_writer.hpp"

namespace isograsp::reports {

using namespace pdf;

namespace {

constexpr double kColumnGap = 10.0;
constexpr double kRowPad = 5.0;
constexpr double kPlotHeight = 190.0;
constexpr double kMostWidening =
    26.0;  // of a column [points]: further apart rows are hard to follow

/// Columns as wide as their longest word or number; the widest give way if the page is too narrow.
std::vector<double> column_widths(const StudyTable& table) {
  const QFontMetricsF metrics(report_font(kBody.size * kUnit, false));
  const auto width_of = [&metrics](const std::string& text) {
    return metrics.horizontalAdvance(qt(text)) / kUnit + 1.0;
  };
  std::vector<double> widths;
  for (std::size_t column = 0; column < table.heads.size(); ++column) {
    double widest = width_of(table.heads[column]);
    for (const auto& row : table.rows) widest = std::max(widest, width_of(row[column]));
    widths.push_back(widest + kColumnGap);
  }
  double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
  const auto columns = static_cast<double>(widths.size());
  if (sum < kWidth) {
    const double wider = std::min(kMostWidening, (kWidth - sum) / columns);
    for (double& width : widths) width += wider;
  }
  while (sum > kWidth) {
    auto widest = std::max_element(widths.begin(), widths.end());
    const double less = std::min(sum - kWidth, std::max(1.0, *widest * 0.05));
    *widest -= less;
    sum -= less;
  }
  return widths;
}

/// One row with a line below it.
Block row_block(const std::vector<std::string>& cells, const std::vector<double>& widths,
                std::size_t words, bool is_head) {
  std::vector<RowCell> placed;
  double x = kSide;
  for (std::size_t column = 0; column < cells.size(); ++column) {
    TextStyle style = is_head ? kQuiet : kBody;
    if (column >= words) style.align = Qt::AlignRight;
    const double indent = column >= words && column > 0 ? kColumnGap : 0.0;
    const double width = widths[column] - (column >= words ? indent : kColumnGap);
    placed.push_back({x + indent, width, qt(cells[column]), style});
    x += widths[column];
  }
  return table_row(placed, x, kRowPad / 2.0, is_head);
}

struct PdfBlocks {
  std::vector<Block>& blocks;

  void operator()(const StudyHeading& heading) const {
    blocks.push_back(heading.large ? heading_block(qt(heading.text), kSectionGap)
                                   : text_block(qt(heading.text), {9.5, true}, kSectionGap * 0.7));
    blocks.back().keep_with_next = true;
  }
  void operator()(const StudyParagraph& paragraph) const {
    blocks.push_back(text_block(qt(paragraph.text), paragraph.quiet ? kQuiet : kBody, 5.0));
  }
  void operator()(const StudyTable& table) const {
    const auto widths = column_widths(table);
    blocks.push_back(text_block(qt(table.caption), kStrong, 10.0));
    blocks.back().keep_with_next = true;
    blocks.push_back(row_block(table.heads, widths, table.words, true));
    constexpr std::size_t kMostTogether = 16;  // rows of a table that is not broken
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      blocks.push_back(row_block(table.rows[row], widths, table.words, false));
      blocks.back().keep_with_next =
          table.rows.size() <= kMostTogether && row + 1 < table.rows.size();
    }
  }
  void operator()(const StudyPlot& plot) const {
    blocks.push_back(text_block(qt(plot.title), kStrong, 12.0));
    blocks.back().keep_with_next = true;
    blocks.push_back({4.0, kPlotHeight, false, {[plot](QCPPainter& painter, double y) {
                        painter.save();
                        painter.translate(kSide * kUnit, y * kUnit);
                        study_plot(plot, {kWidth, kPlotHeight}, kUnit).paint(painter);
                        painter.restore();
                      }}});
  }
};

}  // namespace

std::string study_pdf(const StudyReport& report) {
  std::vector<Block> blocks;
  for (const auto& block : report.blocks) std::visit(PdfBlocks{blocks}, block);
  PdfReport pdf(report.furniture, std::move(blocks));
  while (!pdf.complete()) pdf.paint_next();
  return pdf.take();
}

}  // namespace isograsp::reports
