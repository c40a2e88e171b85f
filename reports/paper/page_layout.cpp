// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/page_layout.hpp"

#include <QAbstractTextDocumentLayout>
#include <QFontMetricsF>
#include <QPainter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <algorithm>

#include "reports/paper/plots.hpp"

namespace isograsp::reports {

namespace {

void set_up(QTextDocument& document, const QString& text, double width_px, const TextStyle& style,
            double unit) {
  document.setDefaultFont(report_font(style.size * unit, style.bold));
  document.setDocumentMargin(0.0);
  document.setUseDesignMetrics(true);
  QTextOption option(style.align);
  option.setWrapMode(
      QTextOption::WrapAtWordBoundaryOrAnywhere);  // no text is wider than its column
  document.setDefaultTextOption(option);
  document.setPlainText(text);
  QTextCursor cursor(&document);
  cursor.select(QTextCursor::Document);
  QTextBlockFormat format;
  format.setLineHeight(style.line_height_percent, QTextBlockFormat::ProportionalHeight);
  cursor.mergeBlockFormat(format);
  document.setTextWidth(width_px);
}

}  // namespace

double TextPainter::height(const QString& text, double width, const TextStyle& style) const {
  QTextDocument document;
  set_up(document, text, width * unit_, style, unit_);
  return document.size().height() / unit_;
}

double TextPainter::word_width(const QString& text, const TextStyle& style) const {
  const QFontMetricsF metrics(report_font(style.size * unit_, style.bold));
  double widest = 0.0;
  for (const QString& line : text.split('\n'))
    for (const QString& word : line.split(' '))
      widest = std::max(widest, metrics.horizontalAdvance(word) / unit_);
  return widest;
}

double TextPainter::draw(QPainter& painter, double x, double y, double width, const QString& text,
                         const TextStyle& style) const {
  QTextDocument document;
  set_up(document, text, width * unit_, style, unit_);
  QAbstractTextDocumentLayout::PaintContext context;
  context.palette.setColor(QPalette::Text, style.color);
  painter.save();
  painter.translate(x * unit_, y * unit_);
  document.documentLayout()->draw(&painter, context);
  painter.restore();
  return document.size().height() / unit_;
}

std::vector<double> widened(std::vector<double> widths, const std::vector<double>& least) {
  const auto room = [&](std::size_t i) { return widths[i] - least[i]; };
  for (std::size_t narrow = 0; narrow < widths.size(); ++narrow)
    while (room(narrow) < 0.0) {
      std::size_t widest = 0;
      for (std::size_t i = 1; i < widths.size(); ++i)
        if (room(i) > room(widest)) widest = i;
      if (room(widest) <= 0.0) return widths;
      const double given = std::min(-room(narrow), room(widest));
      widths[widest] -= given;
      widths[narrow] += given;
    }
  return widths;
}

std::vector<PageRange> break_into_pages(const std::vector<Block>& blocks, double first_height,
                                        double page_height) {
  std::vector<PageRange> pages{{0, 0}};
  double left = first_height;
  std::size_t broken_until = 0;  // blocks before it stand one by one
  for (std::size_t i = 0; i < blocks.size();) {
    // Blocks that belong together move to the next page together, unless they fit on no page.
    std::size_t end = i + 1;
    double height = blocks[i].height;
    while (i >= broken_until && blocks[end - 1].keep_with_next && end < blocks.size()) {
      height += blocks[end].gap_above + blocks[end].height;
      ++end;
    }
    const bool top_of_page = pages.back().first == i;
    if (top_of_page && height > left && end > i + 1) {
      broken_until = end;
      continue;
    }
    const bool with_head = top_of_page && blocks[i].below_head > 0;
    const double above = with_head ? blocks[i - blocks[i].below_head].height : blocks[i].gap_above;
    const double wanted = height + (top_of_page && !with_head ? 0.0 : above);
    if (!top_of_page && (wanted > left || blocks[i].new_page)) {
      pages.push_back({i, i});
      left = page_height;
      continue;
    }
    left -= wanted;
    pages.back().last = end;
    i = end;
  }
  return pages;
}

}  // namespace isograsp::reports
