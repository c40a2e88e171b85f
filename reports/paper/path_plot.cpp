// SPDX-License-Identifier: GPL-3.0-or-later
// The path of the object in the plane, with its targets.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "hand/columns.hpp"
#include "reports/paper/plot_tools.hpp"
#include "reports/paper/plots.hpp"
#include "tasks/task.hpp"

namespace isograsp::reports {

namespace {

constexpr double kMillimetres = 1000.0;

/// Where targets lie; several at one place are one spot.
struct Spot {
  double x_mm;
  double y_mm;
  QString numbers;
};

struct Spots {
  std::vector<Spot> all;
  double radius_mm = 0.0;  ///< within which a target is reached
};

Spots spots_of(const TaskSection& section) {
  Spots spots;
  if (!section.spec || !section.spec->kind->path_drawn) return spots;
  const auto tolerance = section.spec->tolerance();
  if (!tolerance) return spots;
  spots.radius_mm = kMillimetres * tolerance->position_m;
  int number = 0;
  for (const auto& target : section.spec->targets()) {
    const double x_mm = kMillimetres * target.p_WT.x();
    const double y_mm = kMillimetres * target.p_WT.y();
    const auto text = QString::number(++number);
    const auto same = std::find_if(spots.all.begin(), spots.all.end(), [&](const Spot& spot) {
      return spot.x_mm == x_mm && spot.y_mm == y_mm;
    });
    if (same == spots.all.end())
      spots.all.push_back({x_mm, y_mm, text});
    else
      same->numbers += ", " + text;
  }
  return spots;
}

QCPRange extent(const Values& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values)
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  return {low, high};
}

/// The part of the plane that is shown; one millimetre is as long on both axes.
struct Frame {
  QPointF center_mm;
  double mm_per_point;

  [[nodiscard]] QCPRange along(double center, double length) const {
    return {center - mm_per_point * length / 2.0, center + mm_per_point * length / 2.0};
  }
};

/// Round all that is drawn in a field of that size [points].
Frame frame_of(const Values& x, const Values& y, const Spots& spots, QSizeF field) {
  Values x_all = x;
  Values y_all = y;
  for (const Spot& spot : spots.all) {
    x_all << spot.x_mm - spots.radius_mm << spot.x_mm + spots.radius_mm;
    y_all << spot.y_mm - spots.radius_mm << spot.y_mm + spots.radius_mm;
  }
  const QCPRange x_range = extent(x_all);
  const QCPRange y_range = extent(y_all);
  constexpr double kAir = 1.12;
  constexpr double kLeast_mm = 10.0;
  return {{x_range.center(), y_range.center()},
          kAir * std::max({x_range.size() / field.width(), y_range.size() / field.height(),
                           kLeast_mm / field.height()})};
}

void add_curve(QCPAxisRect& rect, const Values& x, const Values& y, const QPen& pen) {
  // The plot owns it.
  auto* curve = new QCPCurve(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  curve->setData(x, y);
  curve->setPen(pen);
}

/// A circle with its numbers, which stand towards the middle of the plot.
void add_spot(PlotView& view, QCPAxisRect& rect, const Spot& spot, double radius_mm,
              const Frame& frame) {
  Values x, y;
  constexpr int kCorners = 72;
  for (int i = 0; i <= kCorners; ++i) {
    const double a = 2.0 * std::numbers::pi * i / kCorners;
    x.push_back(spot.x_mm + radius_mm * std::cos(a));
    y.push_back(spot.y_mm + radius_mm * std::sin(a));
  }
  add_curve(rect, x, y, dashed(Palette::target(), view.px(0.9), {4.0, 2.5}));
  auto* label = new QCPItemText(rect.parentPlot());  // the plot owns it
  label->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  label->setClipToAxisRect(false);
  const bool above = spot.y_mm > frame.center_mm.y();
  constexpr double kGap = 6.0;  // [points]
  const double away_mm = radius_mm + frame.mm_per_point * kGap;
  label->position->setCoords(spot.x_mm, spot.y_mm + (above ? -away_mm : away_mm));
  label->setText(spot.numbers);
  label->setFont(report_font(view.px(6.8), true));
  label->setColor(Palette::ink());
}

/// With its start and its end.
void add_path(PlotView& view, QCPAxisRect& rect, const Values& x, const Values& y,
              const QColor& color, QSizeF field) {
  // A path may cross its place many times: its two coordinates are thinned along time together.
  const int bins = static_cast<int>(2.0 * (field.width() + field.height()) / kFinest);
  QVector<int> rows = visible_rows(x, bins) + visible_rows(y, bins);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  add_curve(rect, picked(x, rows), picked(y, rows), QPen(color, view.px(1.0)));
  const auto add_mark = [&](double x_mm, double y_mm, const QCPScatterStyle& style) {
    QCPGraph& mark = add_line(rect, {x_mm}, {y_mm}, QPen(Qt::NoPen));
    mark.setLineStyle(QCPGraph::lsNone);
    mark.setScatterStyle(style);
  };
  add_mark(x.front(), y.front(),
           {QCPScatterStyle::ssCircle, QPen(color, view.px(1.0)), Qt::white, view.px(5.0)});
  add_mark(x.back(), y.back(),
           {QCPScatterStyle::ssSquare, QPen(color, view.px(1.0)), color, view.px(4.5)});
}

}  // namespace

bool has_path(const TaskSection& section) {
  if (!section.last) return false;
  const Signals& curves = section.last->curves;
  return any_number(curves.column(columns::actual_position[0])) &&
         any_number(curves.column(columns::actual_position[1])) &&
         any_number(curves.column(columns::actual_angle_rad));
}

PlotView path_plot(const TaskSection& section, QSizeF size, double unit, const Language& language) {
  PlotView view(size, unit, language);
  const QSizeF field(size.width() - kLeft - kRight, size.height() - kAboveWithKey - kBelow);
  QCPAxisRect& rect = view.add_axes({kLeft, kAboveWithKey, field.width(), field.height()});
  const Signals& curves = section.last->curves;
  const Values x = scaled(curves.column(columns::actual_position[0]), kMillimetres);
  const Values y = scaled(curves.column(columns::actual_position[1]), kMillimetres);
  const Spots spots = spots_of(section);
  const Frame frame = frame_of(x, y, spots, field);
  rect.axis(QCPAxis::atBottom)->setRange(frame.along(frame.center_mm.x(), field.width()));
  rect.axis(QCPAxis::atLeft)->setRange(frame.along(frame.center_mm.y(), field.height()));
  rect.axis(QCPAxis::atBottom)->setLabel(view.said("x [mm]"_text));
  rect.axis(QCPAxis::atLeft)->setLabel(view.said("y [mm]"_text));
  rect.axis(QCPAxis::atBottom)->grid()->setPen(QPen(Palette::line(), view.px(0.5)));

  for (const Spot& spot : spots.all) add_spot(view, rect, spot, spots.radius_mm, frame);
  const QColor color = Palette::of(section.hand);
  add_path(view, rect, x, y, color, field);
  view.explain(PlotView::Mark::ring, color, "start"_text);
  view.explain(PlotView::Mark::square, color, "end"_text);
  if (!spots.all.empty()) view.explain(PlotView::Mark::dashed, Palette::target(), "target"_text);
  return view;
}

}  // namespace isograsp::reports
