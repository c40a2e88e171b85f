// SPDX-License-Identifier: GPL-3.0-or-later
// Panels as blocks of a PDF report.
#include <algorithm>
#include <utility>

#include <qcustomplot.h>

#include "reports/pdf_content.hpp"

namespace isograsp::pdf {

namespace {

constexpr double kPlotGap = 14.0;
constexpr double kCellSpace = 6.0;
constexpr double kLargeSize = 20.0;
const TextStyle kLarge{kLargeSize, false, Palette::ink(), Qt::AlignLeft, 130.0};
const TextStyle kLargeHeading{34.0, true};

/// Plots side by side, each with its title above.
Block plot_row(const std::vector<PanelPlot>& plots, bool large) {
  const TextStyle& title = large ? kLarge : kStrong;
  const double title_height = large ? 34.0 : 13.0;
  Block block{large ? 22.0 : 6.0, 0.0, false, {}};
  double x = kSide;
  for (const auto& plot : plots) {
    const double width = plot.share * (kWidth + kPlotGap) - kPlotGap;
    block.height = std::max(block.height, title_height + plot.height);
    block.parts.push_back([=, text = text_of(plot.title)](QCPPainter& painter, double y) {
      kText.draw(painter, x, y, width, text, title);
    });
    // The plot is made when it is painted: all of them at once would take much memory.
    block.parts.push_back(
        [=, make = plot.make, height = plot.height](QCPPainter& painter, double y) {
          painter.save();
          painter.translate(x * kUnit, (y + title_height) * kUnit);
          make(QSizeF(width, height), kUnit).paint(painter);
          painter.restore();
        });
    x += width + kPlotGap;
  }
  return block;
}

/// A row whose cells may have a second, smaller line behind a line break.
Block table_row(const PanelTable& table, const std::vector<std::string>& cells, bool is_head) {
  struct Placed {
    double x;
    double width;
    QString text;
    QString under;
    double first_height;
  };
  std::vector<Placed> placed;
  double x = kSide;
  double height = 0.0;
  const TextStyle& style = is_head ? kQuiet : kBody;
  const TextStyle under{6.8, false, Palette::quiet()};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double width = kWidth * table.shares[i];
    const auto lines = text_of(cells[i]).split('\n');
    Placed one{x, width - kCellSpace, lines.front(), lines.value(1), 0.0};
    one.first_height = kText.height(one.text, one.width, style);
    const double second = one.under.isEmpty() ? 0.0 : kText.height(one.under, one.width, under);
    height = std::max(height, one.first_height + second);
    placed.push_back(std::move(one));
    x += width;
  }
  constexpr double kPad = 3.0;
  height += 2.0 * kPad;
  return {0.0, height, is_head, {[=](QCPPainter& painter, double y) {
            for (const auto& one : placed) {
              kText.draw(painter, one.x, y + kPad, one.width, one.text, style);
              if (!one.under.isEmpty())
                kText.draw(painter, one.x, y + kPad + one.first_height, one.width, one.under,
                           under);
            }
            rule(painter, y + height, is_head ? 0.7 : 0.5,
                 is_head ? Palette::quiet() : Palette::line());
          }}};
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
              kText.draw(painter, x, y + kRoom + 3.0, width, text_of(word), kQuiet);
              x += width + kPlotGap;
            }
          }}};
}

void add_panel(std::vector<Block>& blocks, const Panel& panel) {
  const std::size_t first = blocks.size();
  if (panel.large_print) {
    blocks.push_back(text_block(text_of(panel.heading), kLargeHeading, 0.0));
    blocks.back().new_page = true;
    for (const auto& line : panel.lines) blocks.push_back(text_block(text_of(line), kLarge, 16.0));
  } else {
    blocks.push_back(heading_block(text_of(panel.heading), kSectionGap));
    double gap = 0.0;
    for (const auto& line : panel.lines) {
      blocks.push_back(text_block(text_of(line), kBody, gap));
      gap = 2.0;
    }
  }
  if (!panel.plots.empty()) blocks.push_back(plot_row(panel.plots, panel.large_print));
  if (panel.table) {
    blocks.push_back(table_row(*panel.table, panel.table->heads, true));
    blocks.back().gap_above = 4.0;
    for (const auto& row : panel.table->rows) blocks.push_back(table_row(*panel.table, row, false));
  }
  if (!panel.blanks.empty()) blocks.push_back(blanks_row(panel.blanks));
  for (const auto& note : panel.notes) blocks.push_back(text_block(text_of(note), kQuiet, 4.0));
  // A panel stands on one page.
  for (std::size_t i = first; i + 1 < blocks.size(); ++i) blocks[i].keep_with_next = true;
}

}  // namespace

void add_panels(std::vector<Block>& blocks, const std::vector<Panel>& panels) {
  for (const auto& panel : panels) add_panel(blocks, panel);
}

}  // namespace isograsp::pdf
