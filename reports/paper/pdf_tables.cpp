// SPDX-License-Identifier: GPL-3.0-or-later
// Text, the table at a glance and the data-quality box of a PDF report.
#include <algorithm>
#include <array>

#include "reports/findings/report_text.hpp"
#include "reports/paper/pdf_content.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports::pdf {

namespace {

struct Cell {
  QString text;
  TextStyle style;
  QString under;  ///< a second, smaller line
};

/// A block that is painted in one go.
Block block(double gap_above, double height, bool keep_with_next, Draw draw) {
  return {gap_above, height, keep_with_next, {std::move(draw)}};
}

// The table of key measures: shares of the width, space between columns, right-aligned numbers.
constexpr std::array kShares{0.145, 0.165, 0.105, 0.145, 0.19, 0.25};
constexpr double kSpace = 6.0;
constexpr double kVerdictInset = 12.0;
constexpr double kUnderSize = 6.8;

bool is_number(std::size_t column) {
  return column >= 2 && column <= 4;
}
double inset(std::size_t column) {
  if (is_number(column)) return kSpace;
  return column + 1 == kShares.size() ? kVerdictInset : 0.0;
}
/// Beside the text of a column.
double beside(std::size_t column) {
  return (is_number(column) ? 0.0 : kSpace) + inset(column);
}
TextStyle under_style(Qt::Alignment align) {
  return {kUnderSize, false, Palette::quiet(), align};
}

/// No word of a column is broken, if there is room for it.
std::vector<double> widths_of(const std::vector<std::vector<Cell>>& rows) {
  std::vector<double> widths;
  std::vector<double> least(kShares.size(), 0.0);
  for (std::size_t i = 0; i < kShares.size(); ++i) {
    widths.push_back(kWidth * kShares[i]);
    for (const auto& row : rows)
      least[i] = std::max({least[i], beside(i) + kText.word_width(row[i].text, row[i].style),
                           beside(i) + kText.word_width(row[i].under, under_style({}))});
  }
  return widened(std::move(widths), least);
}

Block row_block(std::vector<Cell> cells, const std::vector<double>& widths, bool is_head,
                double rule_width, const QColor& rule_color) {
  std::vector<double> inner;  // widths of texts
  for (std::size_t i = 0; i < cells.size(); ++i) inner.push_back(widths[i] - beside(i));
  constexpr double kHeadHeight = 15.0;
  constexpr double kHeadPad = 3.0;
  constexpr double kLeastHeight = 27.0;
  double height = is_head ? kHeadHeight : kLeastHeight;
  std::vector<double> first_line;  // heights
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (is_number(i)) cells[i].style.align = Qt::AlignRight;
    first_line.push_back(kText.height(cells[i].text, inner[i], cells[i].style));
    height = std::max(height, first_line[i] + (is_head ? kHeadPad : 0.0));
    if (cells[i].under.isEmpty()) continue;
    constexpr double kPad = 6.0;
    height = std::max(
        height, first_line[i] + kPad +
                    kText.height(cells[i].under, inner[i], under_style(cells[i].style.align)));
  }
  auto draw = [=, cells = std::move(cells)](QCPPainter& painter, double y) {
    double x = kSide;
    const double top = y + (is_head ? 1.0 : 4.0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      kText.draw(painter, x + inset(i), top, inner[i], cells[i].text, cells[i].style);
      if (!cells[i].under.isEmpty())
        kText.draw(painter, x + inset(i), top + first_line[i], inner[i], cells[i].under,
                   under_style(cells[i].style.align));
      x += widths[i];
    }
    rule(painter, y + height, rule_width, rule_color);
  };
  return block(0.0, height, is_head, std::move(draw));
}

}  // namespace

Block text_block(const QString& text, const TextStyle& style, double gap_above) {
  return block(gap_above, kText.height(text, kWidth, style), false,
               [text, style](QCPPainter& painter, double y) {
                 kText.draw(painter, kSide, y, kWidth, text, style);
               });
}

Block heading_block(const QString& text, double gap_above) {
  return block(gap_above, 20.0, true, [text](QCPPainter& painter, double y) {
    kText.draw(painter, kSide, y, kWidth, text, kHeading);
  });
}

void add_glance(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say) {
  const auto rows = glance_rows(content, say.language());
  if (rows.empty()) return;
  blocks.push_back(heading_block(qt(say("At a glance"_text)), kSectionGap));
  std::vector<Cell> head;
  for (const Words title :
       {"Task"_text, "Measure"_text, "Baseline"_text, "Last"_text, "Change"_text, "Verdict"_text})
    head.push_back({qt(say(title)), kQuiet, ""});
  std::vector<std::vector<Cell>> cells{std::move(head)};
  for (const auto& row : rows)
    cells.push_back({{qt(row.task), kBody, qt(row.hand)},
                     {qt(row.measure), kBody, qt(row.direction)},
                     {qt(row.baseline), kBody, qt(row.baseline_basis)},
                     {qt(row.last), kStrong, qt(row.beside)},
                     {qt(row.change), kBody, qt(row.mdc)},
                     {qt(row.verdict), row.primary ? kStrong : kBody, qt(row.verdict_basis)}});
  const auto widths = widths_of(cells);
  blocks.push_back(row_block(std::move(cells.front()), widths, true, 0.7, Palette::quiet()));
  for (std::size_t row = 1; row < cells.size(); ++row) {
    blocks.push_back(row_block(std::move(cells[row]), widths, false, 0.5, Palette::line()));
    blocks.back().below_head = row;
  }
  double gap = 6.0;
  for (const auto& note : verdict_notes(content)) {
    blocks.back().keep_with_next = true;
    blocks.push_back(text_block(qt(say(note)), kQuiet, gap));
    gap = 2.0;
  }
}

void add_quality(std::vector<Block>& blocks, const ReportContent& content, const Speaker& say) {
  if (content.quality.empty() || content.sessions.empty()) return;
  blocks.push_back(heading_block(qt(say("Was the last measurement valid?"_text)), kSectionGap));
  constexpr double kPad = 10.0;
  constexpr double kLabel = 84.0;
  struct Line {
    QString label;
    QString text;
    bool attention;
    double height;
  };
  std::vector<Line> lines;
  double height = 2.0 * kPad - 3.0;
  const double text_width = kWidth - 2.0 * kPad - kLabel;
  const auto add = [&](const Text& label, const Text& words, bool attention) {
    const TextStyle& style = attention ? kStrong : kBody;
    const QString text = qt(say(words));
    const QString name = qt(say(label));
    const double tallest =
        std::max(kText.height(text, text_width, style), kText.height(name, kLabel, style));
    lines.push_back({name, text, attention, tallest + 3.0});
    height += lines.back().height;
  };
  add("Session"_text, session_words(content.sessions.back()), false);
  for (const auto& line : content.quality) add(line.label, line.text, line.attention);
  blocks.push_back(block(0.0, height, false, [=](QCPPainter& painter, double y) {
    painter.setPen(QPen(Palette::line(), 0.7 * kUnit));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(kSide * kUnit, y * kUnit, kWidth * kUnit, height * kUnit));
    double line_y = y + kPad;
    for (const auto& line : lines) {
      kText.draw(painter, kSide + kPad, line_y, kLabel, (line.attention ? "! " : "") + line.label,
                 line.attention ? kStrong : TextStyle{8.0, false, Palette::quiet()});
      kText.draw(painter, kSide + kPad + kLabel, line_y, text_width, line.text,
                 line.attention ? kStrong : kBody);
      line_y += line.height;
    }
  }));
}

}  // namespace isograsp::reports::pdf
