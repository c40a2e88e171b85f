// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/paper/plot_tools.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isograsp::reports {

QCPRange range_of(std::initializer_list<const Values*> lists) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Values* list : lists)
    for (const double value : *list)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (!(low <= high)) return {0.0, 1.0};
  const bool from_zero = low >= 0.0 && low < 0.6 * high;
  if (from_zero) low = 0.0;
  // A range far smaller than the values would blow up differences that mean nothing.
  constexpr double kLeastSpan = 0.2;
  const double size = std::max(std::abs(low), std::abs(high));
  const double least = size > 0.0 ? kLeastSpan * size : 1.0;
  const double more = std::max(0.0, least - (high - low)) / 2.0;
  constexpr double kAir = 0.12;
  const double air = kAir * std::max(high - low, least) + more;
  return {from_zero ? 0.0 : low - air, high + air};
}

Values scaled(std::span<const double> column, double factor) {
  Values values;
  values.reserve(static_cast<int>(column.size()));
  for (const double value : column) values.push_back(value * factor);
  return values;
}

bool any_number(std::span<const double> column) {
  return std::any_of(column.begin(), column.end(), [](double v) { return std::isfinite(v); });
}

QCPGraph& add_line(QCPAxisRect& rect, const Values& x, const Values& y, const QPen& pen) {
  QCPGraph* graph =
      rect.parentPlot()->addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  graph->setData(x, y, true);
  graph->setPen(pen);
  return *graph;
}

QCPAxisRect& stacked_axes(PlotView& view, int place, int of, double end_s, Words title) {
  constexpr double kGap = 7.0;
  const QSizeF size = view.size();
  const double each = (size.height() - kAboveWithKey - kBelow - kGap * (of - 1)) / of;
  QCPAxisRect& rect = view.add_axes(
      {kLeft, kAboveWithKey + place * (each + kGap), size.width() - kLeft - kRight, each});
  rect.axis(QCPAxis::atBottom)->setRange(0.0, end_s);
  rect.axis(QCPAxis::atLeft)->setLabel(view.said(title));
  if (of > 1) rect.axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
  const bool last = place == of - 1;
  rect.axis(QCPAxis::atBottom)->setTickLabels(last);
  if (last) rect.axis(QCPAxis::atBottom)->setLabel(view.said("time [s]"_text));
  return rect;
}

SessionSpan session_span(const ReportContent& content) {
  constexpr int kLeastSpan = 3;  // sessions: two points side by side look like a jump otherwise
  const int count = static_cast<int>(content.sessions.size());
  const double low = content.sessions.front().number - 0.5;
  return {low, low + std::max(count, kLeastSpan)};
}

bool ticks_have_dates(const ReportContent& content) {
  constexpr std::size_t kMostDatedTicks = 4;
  return content.sessions.size() <= kMostDatedTicks;
}

void add_session_ticks(const PlotView& view, QCPAxis& axis, const ReportContent& content) {
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  constexpr int kMostTicks = 12;
  const int count = static_cast<int>(content.sessions.size());
  const int step = 1 + (count - 1) / kMostTicks;
  for (int i = 0; i < count; i += step) {
    const auto& session = content.sessions[static_cast<std::size_t>(i)];
    QString label = QString::number(session.number);
    if (ticks_have_dates(content)) label += "\n" + view.said(day_of_year_words(session.date));
    ticker->addTick(session.number, label);
  }
  axis.setTicker(ticker);
}

QPen dashed(const QColor& color, double width, const QVector<qreal>& pattern) {
  QPen pen(color, width);
  pen.setDashPattern(pattern);
  pen.setCapStyle(Qt::FlatCap);
  return pen;
}

QPen link_pen(const PlotView& view, ArmLink link) {
  switch (link) {
    case ArmLink::forearm: return {Palette::ink(), view.px(1.0)};
    case ArmLink::wrist: return {Palette::of(Hand::right), view.px(1.0)};
    case ArmLink::fingers: break;
  }
  return dashed(Palette::of(Hand::left), view.px(1.0), {4.0, 2.0});
}

void explain_link(PlotView& view, ArmLink link) {
  view.explain(link == ArmLink::fingers ? PlotView::Mark::dashed : PlotView::Mark::line,
               link_pen(view, link).color(), link_words(link));
}

QVector<int> visible_rows(const Values& values, int bins) {
  const int count = values.size();
  QVector<int> rows;
  for (int bin = 0, first = 0; first < count; ++bin) {
    // The last bin takes what rounding left over.
    const auto end =
        bin + 1 >= bins ? count : static_cast<int>(static_cast<qint64>(count) * (bin + 1) / bins);
    if (end <= first) continue;
    std::array<int, 4> kept{first, first, first, end - 1};
    int gap = -1;
    for (int i = first; i < end; ++i) {
      if (std::isnan(values[i]))
        gap = i;
      else if (std::isnan(values[kept[1]]))
        kept[1] = kept[2] = i;
      else if (values[i] < values[kept[1]])
        kept[1] = i;
      else if (values[i] > values[kept[2]])
        kept[2] = i;
    }
    QVector<int> of_bin(kept.begin(), kept.end());
    if (gap >= 0) of_bin.push_back(gap);
    std::sort(of_bin.begin(), of_bin.end());
    of_bin.erase(std::unique(of_bin.begin(), of_bin.end()), of_bin.end());
    rows += of_bin;
    first = end;
  }
  return rows;
}

Values picked(const Values& values, const QVector<int>& rows) {
  Values result;
  result.reserve(rows.size());
  for (const int row : rows) result.push_back(values[row]);
  return result;
}

}  // namespace isograsp::reports
