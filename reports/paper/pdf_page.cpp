// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/pdf_page.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/findings/report_text.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports::pdf {

namespace {

/// The source of simulated or replayed forces, at the upper right of every page.
void draw_badge(QPainter& painter, const PageFurniture& furniture, double y) {
  const auto word = qt(furniture.watermark);
  if (word.isEmpty()) return;
  const QFont font = report_font(7.2 * kUnit, true);
  const double width = QFontMetricsF(font).horizontalAdvance(word) / kUnit + 16.0;
  const double x = kPageWidth - kSide - width;
  painter.setPen(QPen(Palette::ink(), 0.9 * kUnit));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(x * kUnit, y * kUnit, width * kUnit, 17.0 * kUnit));
  kText.draw(painter, x, y + 4.0, width, word,
             {7.2, true, Palette::ink(), Qt::AlignHCenter, 100.0});
}

/// Each on one line, if there is room.
std::vector<double> fact_widths(const std::vector<Fact>& facts, const TextStyle& value) {
  constexpr double kShares[] = {1.75, 1.25, 0.65, 0.85, 1.25};
  constexpr double kGap = 11.0;
  const auto whole = [](std::string text, const TextStyle& style) {
    return kText.word_width(qt(text).replace(' ', QChar::Nbsp), style);
  };
  double total = 0.0;
  for (std::size_t i = 0; i < facts.size(); ++i) total += kShares[i];
  std::vector<double> widths;
  std::vector<double> least;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    widths.push_back(kWidth * kShares[i] / total);
    least.push_back(kGap + std::max(whole(facts[i].label, kQuiet), whole(facts[i].value, value)));
  }
  return widened(std::move(widths), least);
}

void draw_header(QPainter& painter, const PageFurniture& furniture) {
  kText.draw(painter, kSide, 46.0, kWidth, "IsoGrasp \u00b7 " + qt(furniture.kind),
             {8.5, false, Palette::quiet()});
  kText.draw(painter, kSide, 59.0, kWidth, qt(furniture.title),
             {furniture.title.size() > kLongTitle ? 14.0 : 24.0, true});
  draw_badge(painter, furniture, 50.0);
  const double y = 102.0;
  rule(painter, y, 0.9, Palette::ink());
  const auto& facts = furniture.facts;
  static const TextStyle kValue{8.8, true};
  const auto widths = fact_widths(facts, kValue);
  double x = kSide;
  for (std::size_t i = 0; i < facts.size(); ++i) {
    kText.draw(painter, x, y + 9.0, widths[i], qt(facts[i].label), kQuiet);
    kText.draw(painter, x, y + 20.0, widths[i], qt(facts[i].value), kValue);
    x += widths[i];
  }
  rule(painter, y + 40.0, 0.5, Palette::line());
}

/// Across the page, faint enough to read through, impossible to crop away.
void draw_watermark(QPainter& painter, const PageFurniture& furniture) {
  const auto word = qt(furniture.watermark);
  if (word.isEmpty()) return;
  painter.save();
  painter.translate(kPageWidth / 2.0 * kUnit, kPageHeight / 2.0 * kUnit);
  painter.rotate(-std::atan2(kPageHeight, kPageWidth) * 180.0 / M_PI);
  const double size = word.size() > 20 ? 36.0 : 58.0;
  const QFont font = report_font(size * kUnit, true);
  constexpr int kFaint = 13;  // of 255
  painter.setPen(QColor(0, 0, 0, kFaint));
  painter.setFont(font);
  const double width = QFontMetricsF(font).horizontalAdvance(word);
  painter.drawText(QPointF(-width / 2.0, size * kUnit * 0.36), word);
  painter.restore();
}

}  // namespace

void rule(QPainter& painter, double y, double width, const QColor& color, double right) {
  painter.setPen(QPen(color, width * kUnit));
  painter.drawLine(QPointF(kSide * kUnit, y * kUnit), QPointF(right * kUnit, y * kUnit));
}

Block table_row(const std::vector<RowCell>& cells, double right, double pad, bool is_head) {
  std::vector<std::pair<RowCell, double>> placed;  // and the height of its text
  double height = 0.0;
  for (const RowCell& cell : cells) {
    const double first = kText.height(cell.text, cell.width, cell.style);
    const double second = cell.under.isEmpty() ? 0.0 : kText.height(cell.under, cell.width, kUnder);
    height = std::max(height, first + second);
    placed.emplace_back(cell, first);
  }
  height += 2.0 * pad;
  return {0.0, height, is_head, {[=](QCPPainter& painter, double y) {
            for (const auto& [cell, first] : placed) {
              kText.draw(painter, cell.x, y + pad, cell.width, cell.text, cell.style);
              if (!cell.under.isEmpty())
                kText.draw(painter, cell.x, y + pad + first, cell.width, cell.under, kUnder);
            }
            rule(painter, y + height, is_head ? 0.7 : 0.5,
                 is_head ? Palette::quiet() : Palette::line(), right);
          }}};
}

void draw_head(QPainter& painter, const PageFurniture& furniture, int page) {
  if (page == 1) return draw_header(painter, furniture);
  kText.draw(painter, kSide, 34.0, kWidth, qt(furniture.kind + " \u00b7 " + furniture.title),
             kQuiet);
  draw_badge(painter, furniture, 26.0);
}

void draw_foot(QPainter& painter, const PageFurniture& furniture, int page, int pages) {
  const double y = kPageHeight - 44.0;
  rule(painter, y - 6.0, 0.5, Palette::line());
  const TextStyle small{6.4, false, Palette::quiet()};
  kText.draw(painter, kSide, y, kWidth - 80.0, qt(furniture.footer), small);
  TextStyle number = small;
  number.align = Qt::AlignRight;
  kText.draw(painter, kPageWidth - kSide - 76.0, y, 76.0,
             qt(translated("page %1 of %2"_text(page, pages), *furniture.language)), number);
  draw_watermark(painter, furniture);
}

}  // namespace isograsp::reports::pdf
