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

bool has_path(const TaskSection& section) {
  if (!section.last) return false;
  const Signals& curves = section.last->curves;
  return any_number(curves.column(columns::actual_position[0])) &&
         any_number(curves.column(columns::actual_position[1])) &&
         any_number(curves.column(columns::actual_angle_rad));
}

PlotView path_plot(const TaskSection& section, QSizeF size, double unit) {
  PlotView view(size, unit);
  const double width = size.width() - kLeft - kRight;
  const double height = size.height() - kAboveWithKey - kBelow;
  QCPAxisRect& rect = view.add_axes({kLeft, kAboveWithKey, width, height});
  const Signals& curves = section.last->curves;
  constexpr double kMillimetres = 1000.0;
  Values x = scaled(curves.column(columns::actual_position[0]), kMillimetres);
  Values y = scaled(curves.column(columns::actual_position[1]), kMillimetres);

  struct Spot {
    double x_mm;
    double y_mm;
    QString numbers;
  };
  std::vector<Spot> spots;
  double radius_mm = 0.0;
  if (section.spec && section.spec->kind->way_drawn)
    if (const auto tolerance = section.spec->tolerance()) {
      radius_mm = kMillimetres * tolerance->position_m;
      int number = 0;
      for (const auto& target : section.spec->targets()) {
        const double tx = kMillimetres * target.p_WT.x();
        const double ty = kMillimetres * target.p_WT.y();
        const auto text = QString::number(++number);
        const auto same = std::find_if(spots.begin(), spots.end(), [&](const Spot& spot) {
          return spot.x_mm == tx && spot.y_mm == ty;
        });
        if (same == spots.end())
          spots.push_back({tx, ty, text});
        else
          same->numbers += ", " + text;
      }
    }
  Values x_all = x;
  Values y_all = y;
  for (const Spot& spot : spots) {
    x_all << spot.x_mm - radius_mm << spot.x_mm + radius_mm;
    y_all << spot.y_mm - radius_mm << spot.y_mm + radius_mm;
  }
  // One millimetre is as long on both axes.
  const auto extent = [](const Values& values) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values)
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    return QCPRange(low, high);
  };
  const QCPRange x_range = extent(x_all);
  const QCPRange y_range = extent(y_all);
  constexpr double kAir = 1.12;
  constexpr double kLeast_mm = 10.0;
  const double scale =
      kAir * std::max({x_range.size() / width, y_range.size() / height, kLeast_mm / height});
  rect.axis(QCPAxis::atBottom)
      ->setRange(x_range.center() - scale * width / 2.0, x_range.center() + scale * width / 2.0);
  rect.axis(QCPAxis::atLeft)
      ->setRange(y_range.center() - scale * height / 2.0, y_range.center() + scale * height / 2.0);
  rect.axis(QCPAxis::atBottom)->setLabel("x [mm]");
  rect.axis(QCPAxis::atLeft)->setLabel("y [mm]");
  rect.axis(QCPAxis::atBottom)->grid()->setPen(QPen(Palette::line(), view.px(0.5)));

  const auto add_curve = [&](const Values& xs, const Values& ys, const QPen& pen) {
    auto* curve = new QCPCurve(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    curve->setData(xs, ys);
    curve->setPen(pen);
  };
  const double label_gap_mm = scale * 6.0;
  for (const Spot& spot : spots) {
    Values cx, cy;
    constexpr int kCorners = 72;
    for (int i = 0; i <= kCorners; ++i) {
      const double a = 2.0 * std::numbers::pi * i / kCorners;
      cx.push_back(spot.x_mm + radius_mm * std::cos(a));
      cy.push_back(spot.y_mm + radius_mm * std::sin(a));
    }
    add_curve(cx, cy, dashed(Palette::target(), view.px(0.9), {4.0, 2.5}));
    auto* label = new QCPItemText(rect.parentPlot());  // the plot owns it
    label->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    label->setClipToAxisRect(false);
    const bool above = spot.y_mm > y_range.center();
    label->position->setCoords(spot.x_mm,
                               spot.y_mm + (above ? -1 : 1) * (radius_mm + label_gap_mm));
    label->setText(spot.numbers);
    label->setFont(report_font(view.px(6.8), true));
    label->setColor(Palette::ink());
  }
  const QColor color = Palette::of(section.hand);
  // A path may cross its place many times: its two coordinates are thinned along time together.
  const int bins = static_cast<int>(2.0 * (width + height) / kFinest);
  QVector<int> rows = visible_rows(x, bins) + visible_rows(y, bins);
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  add_curve(picked(x, rows), picked(y, rows), QPen(color, view.px(1.0)));
  const auto add_mark = [&](double px_mm, double py_mm, const QCPScatterStyle& style) {
    QCPGraph& mark = add_line(rect, {px_mm}, {py_mm}, QPen(Qt::NoPen));
    mark.setLineStyle(QCPGraph::lsNone);
    mark.setScatterStyle(style);
  };
  add_mark(x.front(), y.front(),
           {QCPScatterStyle::ssCircle, QPen(color, view.px(1.0)), Qt::white, view.px(5.0)});
  add_mark(x.back(), y.back(),
           {QCPScatterStyle::ssSquare, QPen(color, view.px(1.0)), color, view.px(4.5)});
  view.explain(PlotView::Mark::ring, color, "start");
  view.explain(PlotView::Mark::square, color, "end");
  if (!spots.empty()) view.explain(PlotView::Mark::dashed, Palette::target(), "target");
  return view;
}

}  // namespace isograsp::reports
