// SPDX-License-Identifier: GPL-3.0-or-later
// Panels as blocks of a PDF report.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "reports/paper/pdf_content.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports::pdf {

namespace {

constexpr double kPlotGap = 14.0;
constexpr double kCellSpace = 6.0;
const TextStyle kLargeHeading{34.0, true};
constexpr double kLargeGap = 16.0;
constexpr double kLargePlotGap = 22.0;
constexpr double kLargePlotTitle = 34.0;

TextStyle large_style(double size) {
  return {size, false, Palette::ink(), Qt::AlignLeft, 130.0};
}

/// The page for the patient: how large its letters and how high its picture, so that all of it
/// stands on one page. Where even the smallest are too large it goes on on the next.
struct LargePrint {
  TextStyle text;
  double plot_height;
};
LargePrint fitted(const Panel& panel) {
  constexpr double kPage = kPageHeight - kTop - kBottom;
  constexpr double kLeastPlot = 130.0;
  constexpr std::array kSizes{20.0, 18.0, 16.0};
  const double wanted = panel.plots.empty() ? 0.0 : panel.plots.front().height;
  const double least = std::min(wanted, kLeastPlot);
  for (const double size : kSizes) {
    const TextStyle style = large_style(size);
    double left = kPage - kText.height(qt(panel.heading), kWidth, kLargeHeading);
    for (const auto& line : panel.lines) left -= kLargeGap + kText.height(qt(line), kWidth, style);
    if (!panel.plots.empty()) left -= kLargePlotGap + kLargePlotTitle;
    if (left >= least) return {style, std::min(wanted, left)};
  }
  return {large_style(kSizes.back()), least};
}

/// A text that may be longer than a page, in pieces that are not.
void add_text(std::vector<Block>& blocks, const std::string& text, const TextStyle& style,
              double gap_above) {
  constexpr double kTallest = 300.0;
  const QString whole = qt(text);
  const int pieces = 1 + static_cast<int>(kText.height(whole, kWidth, style) / kTallest);
  const int length = whole.size() / pieces + 1;
  for (int from = 0; from < whole.size() || from == 0;) {
    int end = whole.size();
    if (pieces > 1 && from + length < end) {
      const int space = whole.lastIndexOf(' ', from + length);
      end = space > from ? space + 1 : from + length;
    }
    blocks.push_back(text_block(whole.mid(from, end - from), style, from == 0 ? gap_above : 0.0));
    if (end == 0) break;
    from = end;
  }
}

/// Plots side by side, each with its title above.
Block plot_row(const std::vector<PanelPlot>& plots, const std::optional<LargePrint>& large) {
  const TextStyle title = large ? large->text : kStrong;
  const double title_height = large ? kLargePlotTitle : 13.0;
  Block block{large ? kLargePlotGap : 6.0, 0.0, false, {}};
  double x = kSide;
  for (const auto& plot : plots) {
    const double width = plot.share * (kWidth + kPlotGap) - kPlotGap;
    const double height = large ? large->plot_height : plot.height;
    block.height = std::max(block.height, title_height + height);
    block.parts.push_back([=, text = qt(plot.title)](QCPPainter& painter, double y) {
      kText.draw(painter, x, y, width, text, title);
    });
    // The plot is made when it is painted: all of them at once would take much memory.
    block.parts.push_back([=, make = plot.make](QCPPainter& painter, double y) {
      painter.save();
      painter.translate(x * kUnit, (y + title_height) * kUnit);
      make(QSizeF(width, height), kUnit).paint(painter);
      painter.restore();
    });
    x += width + kPlotGap;
  }
  return block;
}

/// No word of a column is broken, if there is room for it.
std::vector<double> widths_of(const PanelTable& table) {
  std::vector<double> widths;
  std::vector<double> least;
  for (std::size_t i = 0; i < table.shares.size(); ++i) {
    widths.push_back(kWidth * table.shares[i]);
    double word = kText.word_width(qt(table.heads[i]), kQuiet);
    for (const auto& row : table.rows) {
      const auto lines = qt(row[i]).split('\n');
      word = std::max(
          {word, kText.word_width(lines.front(), kBody), kText.word_width(lines.value(1), kUnder)});
    }
    least.push_back(word + kCellSpace);
  }
  return widened(std::move(widths), least);
}

/// A row whose cells may have a second, smaller line behind a line break.
Block panel_row(const std::vector<double>& widths, const std::vector<std::string>& cells,
                bool is_head) {
  constexpr double kPad = 3.0;
  std::vector<RowCell> placed;
  double x = kSide;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double width = widths[i];
    const auto lines = qt(cells[i]).split('\n');
    placed.push_back(
        {x, width - kCellSpace, lines.front(), is_head ? kQuiet : kBody, lines.value(1)});
    x += width;
  }
  return table_row(placed, kPageWidth - kSide, kPad, is_head);
}

Block blanks_row(const std::vector<std::string>& words) {
  constexpr double kRoom = 34.0;
  return {6.0, kRoom + 14.0, false, {[words](QCPPainter& painter, double y) {
            const auto n = static_cast<double>(words.size());
            const double width = (kWidth - (n - 1.0) * kPlotGap) / n;
            double x = kSide;
            for (const auto& word : words) {
              painter.setPen(QPen(Palette::ink(), 0.7 * kUnit));
              painter.drawLine(QPointF(x * kUnit, (y + kRoom) * kUnit),
                               QPointF((x + width) * kUnit, (y + kRoom) * kUnit));
              kText.draw(painter, x, y + kRoom + 3.0, width, qt(word), kQuiet);
              x += width + kPlotGap;
            }
          }}};
}

void add_panel(std::vector<Block>& blocks, const Panel& panel) {
  const std::size_t first = blocks.size();
  std::optional<LargePrint> large;
  if (panel.large_print) {
    large = fitted(panel);
    blocks.push_back(text_block(qt(panel.heading), kLargeHeading, 0.0));
    blocks.back().new_page = true;
    for (const auto& line : panel.lines) add_text(blocks, line, large->text, kLargeGap);
  } else {
    blocks.push_back(panel.of_task ? text_block(qt(panel.heading), kStrong, 8.0)
                                   : heading_block(qt(panel.heading), kSectionGap));
    blocks.back().new_page = panel.own_page;
    double gap = 0.0;
    for (const auto& line : panel.lines) {
      add_text(blocks, line, kBody, gap);
      gap = 2.0;
    }
  }
  if (!panel.plots.empty()) blocks.push_back(plot_row(panel.plots, large));
  if (panel.table) {
    const auto widths = widths_of(*panel.table);
    blocks.push_back(panel_row(widths, panel.table->heads, true));
    blocks.back().gap_above = 4.0;
    const std::size_t head = blocks.size() - 1;
    for (const auto& row : panel.table->rows) {
      blocks.push_back(panel_row(widths, row, false));
      blocks.back().below_head = blocks.size() - 1 - head;
    }
  }
  if (!panel.blanks.empty()) blocks.push_back(blanks_row(panel.blanks));
  for (const auto& note : panel.notes) blocks.push_back(text_block(qt(note), kQuiet, 4.0));
  // A panel stands on one page.
  for (std::size_t i = first; i + 1 < blocks.size(); ++i) blocks[i].keep_with_next = true;
}

}  // namespace

void add_panels(std::vector<Block>& blocks, const std::vector<Panel>& panels) {
  for (const auto& panel : panels) add_panel(blocks, panel);
}

}  // namespace isograsp::reports::pdf
