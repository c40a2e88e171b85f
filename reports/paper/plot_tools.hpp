// SPDX-License-Identifier: GPL-3.0-or-later
// What the plots of a report share: margins, ranges, lines, fewer points than samples.
#pragma once

#include <initializer_list>
#include <span>

#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

// Distances from the edges of a plot to its axes [points]; equal everywhere, so that axes align.
inline constexpr double kLeft = 34.0;
inline constexpr double kRight = 6.0;
inline constexpr double kBelow = 27.0;
inline constexpr double kAboveWithKey = 14.0;

inline constexpr double kFinest = 1.0;  ///< detail along an axis [points]: the width of a line

using Values = QVector<double>;

/// Smallest range around all numbers, with some air; from zero where the values allow it.
[[nodiscard]] QCPRange range_of(std::initializer_list<const Values*> lists);

[[nodiscard]] Values scaled(std::span<const double> column, double factor);
[[nodiscard]] bool any_number(std::span<const double> column);

QCPGraph& add_line(QCPAxisRect& rect, const Values& x, const Values& y, const QPen& pen);

/// One of `of` pairs of axes below each other over one time, which ends at `end_s`; 0 is the top.
QCPAxisRect& stacked_axes(PlotView& view, int place, int of, double end_s, Words title);

/// Where the sessions of a report stand along an axis.
struct SessionSpan {
  double low;
  double high;
};
[[nodiscard]] SessionSpan session_span(const ReportContent& content);
/// Their numbers, of a few with their days in a second line, kDateLine high.
[[nodiscard]] bool ticks_have_dates(const ReportContent& content);
inline constexpr double kDateLine = 8.0;  // [points]
void add_session_ticks(const PlotView& view, QCPAxis& axis, const ReportContent& content);

[[nodiscard]] QPen dashed(const QColor& color, double width, const QVector<qreal>& pattern);

/// The line of a link of an arm, told apart without its colour, and its word in the key.
[[nodiscard]] QPen link_pen(const PlotView& view, ArmLink link);
void explain_link(PlotView& view, ArmLink link);

/// Indices of the values that a line needs so that it looks the same in `bins` equal pieces of its
/// length: first, smallest, largest and last of each, and the gaps (NaN). Jugel et al., "M4: a
/// visualization-oriented time series data aggregation", Proc. VLDB 2014; 7 (10): 797-808.
[[nodiscard]] QVector<int> visible_rows(const Values& values, int bins);
/// The values at `rows`.
[[nodiscard]] Values picked(const Values& values, const QVector<int>& rows);

}  // namespace isograsp::reports
