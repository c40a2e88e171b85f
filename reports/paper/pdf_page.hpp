// SPDX-License-Identifier: GPL-3.0-or-later
// The page of a PDF report and its furniture: margins, styles, header, footer, watermark.
// Sizes in points (1/72 inch).
#pragma once

#include "reports/paper/page_furniture.hpp"
#include "reports/paper/page_layout.hpp"
#include "reports/paper/plots.hpp"

namespace isograsp::reports::pdf {

inline constexpr int kResolution = 1200;  // per inch: text is laid out on this grid
inline constexpr double kUnit = kResolution / 72.0;
// A4 and its margins
inline constexpr double kPageWidth = 595.0;
inline constexpr double kPageHeight = 842.0;
inline constexpr double kSide = 48.0;
inline constexpr double kTop = 58.0;
inline constexpr double kBottom = 58.0;
inline constexpr double kWidth = kPageWidth - 2.0 * kSide;
inline constexpr double kHeaderHeight = 158.0;  // where the first page's content begins

inline const TextPainter kText{kUnit};
inline const TextStyle kBody{8.0};
inline const TextStyle kStrong{8.0, true};
inline const TextStyle kQuiet{7.2, false, Palette::quiet()};
inline const TextStyle kUnder{6.8, false, Palette::quiet()};
inline const TextStyle kHeading{11.5, true};

[[nodiscard]] inline QString qt(const std::string& text) {
  return QString::fromStdString(text);
}

/// A line from the left margin to `right`.
void rule(QPainter& painter, double y, double width, const QColor& color,
          double right = kPageWidth - kSide);

/// A cell of a row of a table; `under`: smaller, below the text.
struct RowCell {
  double x = 0.0;
  double width = 0.0;
  QString text;
  TextStyle style;
  QString under = {};
};
/// As high as its highest cell, with `pad` above and below, and a line from the margin to `right`.
[[nodiscard]] Block table_row(const std::vector<RowCell>& cells, double right, double pad,
                              bool is_head);

/// What stands on a page besides its content. `page` counts from 1.
void draw_head(QPainter& painter, const PageFurniture& furniture, int page);
void draw_foot(QPainter& painter, const PageFurniture& furniture, int page, int pages);

}  // namespace isograsp::reports::pdf
