// SPDX-License-Identifier: GPL-3.0-or-later
// A broad river from above: the band is its fairway between buoys, the own force a sailing boat.
#include <algorithm>
#include <cmath>

#include "gui/training_looks/curve_looks.hpp"
#include "gui/training_looks/curve_view.hpp"
#include "gui/training_looks/landscape.hpp"

namespace isograsp::gui {

namespace {

using namespace landscape;

struct RiverColours {
  QColor shallow, deep, fairway, edge, ripple, land, wood, sand;
};

const RiverColours& river_colours(tasks::Daylight light) {
  static const RiverColours kMorning{{0xCF, 0xE3, 0xE2}, {0xB4, 0xD3, 0xD6}, {0x4F, 0x93, 0xA3},
                                     {0x1E, 0x5A, 0x6B}, {0xF4, 0xFA, 0xF8}, {0xC9, 0xD8, 0xAE},
                                     {0x6F, 0x93, 0x68}, {0xEF, 0xE4, 0xC8}};
  static const RiverColours kDay{{0xBF, 0xE2, 0xE6}, {0x9C, 0xD0, 0xDA}, {0x2F, 0x86, 0xA6},
                                 {0x0C, 0x4C, 0x68}, {0xFF, 0xFF, 0xFF}, {0xB5, 0xD2, 0x94},
                                 {0x4F, 0x82, 0x55}, {0xF1, 0xE5, 0xBE}};
  static const RiverColours kEvening{{0xE6, 0xD3, 0xD2}, {0xC9, 0xB9, 0xCE}, {0x66, 0x74, 0xA4},
                                     {0x2F, 0x3A, 0x62}, {0xFF, 0xF3, 0xE0}, {0xC9, 0xC1, 0x92},
                                     {0x72, 0x7A, 0x56}, {0xF0, 0xDD, 0xBC}};
  return in(light, kMorning, kDay, kEvening);
}

/// Water that grows deeper towards the middle.
void paint_water(QPainter& painter, const QRectF& area, const RiverColours& colours) {
  QLinearGradient across(area.topLeft(), area.bottomLeft());
  across.setColorAt(0.0, colours.shallow);
  across.setColorAt(0.5, colours.deep);
  across.setColorAt(1.0, colours.shallow);
  painter.fillRect(area, across);
}

/// One bank: a soft line of land with its beach, that goes by.
void paint_bank(QPainter& painter, const CurveView& view, const RiverColours& colours, bool upper) {
  const QRectF& field = view.field;
  const double depth = 0.075 * field.height();
  const double from = upper ? field.top() : field.bottom();
  const double inward = upper ? 1.0 : -1.0;
  const auto shore = [&](double x) {
    const double s = (x - field.left()) / view.px_per_s + view.begin_s;
    return depth * (0.62 + 0.24 * std::sin(0.9 * s + (upper ? 0.0 : 2.1)) +
                    0.14 * std::sin(2.3 * s + (upper ? 1.0 : 0.3)));
  };
  for (const bool beach : {true, false}) {
    QPolygonF land;
    land << QPointF(field.left(), from);
    constexpr int kSteps = 64;
    for (int k = 0; k <= kSteps; ++k) {
      const double x = field.left() + field.width() * k / kSteps;
      land << QPointF(x, from + inward * (shore(x) + (beach ? 0.016 * field.height() : 0.0)));
    }
    land << QPointF(field.right(), from);
    painter.setPen(Qt::NoPen);
    painter.setBrush(beach ? colours.sand : colours.land);
    painter.drawPolygon(land);
  }
  // Trees from above, each a crown with its light side.
  constexpr double kApart_s = 0.22;
  const auto first = static_cast<std::int64_t>(std::floor(view.begin_s / kApart_s)) - 1;
  const auto last = static_cast<std::int64_t>(
                        std::ceil((view.begin_s + field.width() / view.px_per_s) / kApart_s)) +
                    1;
  for (auto place = first; place <= last; ++place) {
    const int salt = upper ? 1 : 2;
    if (scattered(place, salt) < 0.45) continue;
    const double radius = (0.011 + 0.013 * scattered(place, salt + 10)) * field.height();
    const double s = (static_cast<double>(place) + scattered(place, salt + 20)) * kApart_s;
    const double x = field.left() + (s - view.begin_s) * view.px_per_s;
    const QPointF crown(x, from + inward * 0.42 * shore(x));
    painter.setBrush(QColor(20, 50, 50, 45));
    painter.drawEllipse(crown + QPointF(0.35 * radius, 0.45 * radius), radius, radius);
    painter.setBrush(mixed(colours.wood, colours.land, 0.45 * scattered(place, salt + 30)));
    painter.drawEllipse(crown, radius, radius);
    painter.setBrush(mixed(colours.wood, Qt::white, 0.25));
    painter.drawEllipse(crown - QPointF(0.25 * radius, 0.3 * radius), 0.5 * radius, 0.5 * radius);
  }
}

void draw_ripple(QPainter& painter) {
  painter.setPen(QPen(QColor(255, 255, 255, 150), 0.42, Qt::SolidLine, Qt::RoundCap));
  QPainterPath wave(QPointF(-4.0, 0.3));
  wave.quadTo(QPointF(-2.0, -0.9), QPointF(0.0, 0.0));
  wave.quadTo(QPointF(2.0, 0.9), QPointF(4.0, -0.3));
  painter.drawPath(wave);
}

void paint_ripples(QPainter& painter, const CurveView& view) {
  static thread_local Sprite ripple;
  const QRectF& field = view.field;
  constexpr double kApart_s = 0.30;
  const auto first = static_cast<std::int64_t>(std::floor(view.begin_s / kApart_s)) - 1;
  const auto last = static_cast<std::int64_t>(
                        std::ceil((view.begin_s + field.width() / view.px_per_s) / kApart_s)) +
                    1;
  for (auto place = first; place <= last; ++place)
    for (int row = 0; row < 2; ++row) {
      const double s = (static_cast<double>(place) + scattered(place, 40 + row)) * kApart_s;
      const double x = field.left() + (s - view.begin_s) * view.px_per_s;
      const double y = field.top() + field.height() * (0.14 + 0.72 * scattered(place, 50 + row));
      ripple.draw(painter, {x, y}, 0.009 * field.height(), draw_ripple);
    }
}

/// The way that the boat is asked to keep, between two lines of buoys.
void paint_fairway(QPainter& painter, const CurveView& view, const RiverColours& colours) {
  const double unit = view.field.height();
  for (const QPolygonF& line : view.targets) {
    if (line.size() < 2) continue;
    paint_way(painter, view, line, 0.010 * unit,
              {mixed(colours.fairway, colours.deep, 0.6), colours.edge, colours.fairway});
    QColor middle = colours.ripple;
    middle.setAlpha(190);
    painter.setPen(QPen(middle, 0.005 * unit, Qt::SolidLine, Qt::RoundCap));
    paint_dashes(painter, view, line);
  }
}

void paint_buoys(QPainter& painter, const CurveView& view) {
  constexpr double kApart_s = 0.75;
  const double radius = 0.012 * view.field.height();
  for (const QPolygonF& line : view.targets) {
    for (int k = 0; k + 1 < line.size(); ++k) {
      const auto second = [&](const QPointF& p) {
        return ((p.x() - view.field.left()) / view.px_per_s + view.begin_s) / kApart_s;
      };
      const double here = std::floor(second(line[k + 1]));
      if (std::floor(second(line[k])) == here) continue;
      const double share = (here - second(line[k])) / (second(line[k + 1]) - second(line[k]));
      const QPointF at = line[k] + share * (line[k + 1] - line[k]);
      for (const double side : {-1.0, 1.0}) {
        const QPointF buoy = at + QPointF(0, side * view.half_band_px);
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(10, 40, 60, 70));
        painter.drawEllipse(buoy + QPointF(0.3 * radius, 0.5 * radius), radius, radius);
        painter.setPen(QPen(Qt::white, 0.35 * radius));
        painter.setBrush(side < 0 ? QColor(0xB8, 0x3A, 0x2E) : QColor(0x1E, 0x7A, 0x4E));
        painter.drawEllipse(buoy, radius, radius);
      }
    }
  }
}

/// A small sailing boat from above, its bow to the right; its mast is the mark.
void draw_boat(QPainter& painter) {
  painter.setPen(Qt::NoPen);
  for (const double side : {-1.0, 1.0}) {  // its wake, ever wider
    QPainterPath wake(QPointF(-1.2, 0.35 * side));
    wake.quadTo(QPointF(-2.4, 0.55 * side), QPointF(-4.0, 1.3 * side));
    wake.quadTo(QPointF(-2.5, 0.30 * side), QPointF(-1.4, 0.12 * side));
    QLinearGradient foam(QPointF(-1.2, 0.0), QPointF(-4.0, 0.0));
    foam.setColorAt(0.0, QColor(255, 255, 255, 220));
    foam.setColorAt(1.0, QColor(255, 255, 255, 0));
    painter.setBrush(foam);
    painter.drawPath(wake);
  }
  QPainterPath hull(QPointF(2.25, 0.0));
  hull.cubicTo(QPointF(1.5, -0.72), QPointF(0.3, -1.0), QPointF(-1.45, -0.72));
  hull.quadTo(QPointF(-1.7, 0.0), QPointF(-1.45, 0.72));
  hull.cubicTo(QPointF(0.3, 1.0), QPointF(1.5, 0.72), QPointF(2.25, 0.0));
  painter.setBrush(QColor(10, 35, 55, 70));
  painter.drawPath(hull.translated(0.20, 0.34));
  painter.setPen(QPen(Qt::white, 0.15));
  painter.setBrush(QColor(0x6E, 0x3F, 0x1E));
  painter.drawPath(hull);
  painter.save();
  painter.scale(0.82, 0.74);
  painter.setPen(Qt::NoPen);
  QLinearGradient deck(QPointF(0, -0.9), QPointF(0, 0.9));
  deck.setColorAt(0.0, QColor(0xE6, 0xBE, 0x86));
  deck.setColorAt(1.0, QColor(0xC4, 0x8F, 0x55));
  painter.setBrush(deck);
  painter.drawPath(hull);
  painter.setPen(QPen(QColor(0xA0, 0x6C, 0x38), 0.05));
  for (const double y : {-0.45, -0.15, 0.15, 0.45})
    painter.drawLine(QPointF(-1.45, y), QPointF(1.5, y));
  painter.restore();
  painter.setPen(QPen(QColor(0x5A, 0x35, 0x1A), 0.12));
  for (const double x : {-0.95, 0.95}) painter.drawLine(QPointF(x, -0.62), QPointF(x, 0.62));
  // Sail and foresail, bellied by the wind.
  const auto cloth = [&painter](const QPointF& fore, const QPointF& aft, double belly) {
    QPainterPath sail(fore);
    const QPointF middle = 0.5 * (fore + aft) + QPointF(0, -belly);
    sail.quadTo(middle, aft);
    sail.quadTo(0.5 * (fore + aft) + QPointF(0, -0.28 * belly), fore);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(10, 35, 55, 60));
    painter.drawPath(sail.translated(0.12, 0.22));
    painter.setPen(QPen(QColor(0x0B, 0x3F, 0x78), 0.07));
    painter.setBrush(QColor(0xFB, 0xFC, 0xFD));
    painter.drawPath(sail);
  };
  cloth({0.15, -0.02}, {-1.75, -0.55}, 1.25);
  cloth({2.1, -0.05}, {0.25, -0.40}, 0.75);
}

void paint_boat(QPainter& painter, const CurveView& view) {
  static thread_local Sprite boat;
  const double r = view.mark_radius_px;
  constexpr double kSteepest_deg = 32.0;
  painter.save();
  painter.translate(view.mark);
  painter.rotate(std::clamp(heading_deg(view), -kSteepest_deg, kSteepest_deg));
  boat.draw(painter, {0, 0}, r, draw_boat);
  painter.restore();
  paint_own(painter, view, 0.46 * r);
}

}  // namespace

void paint_river(QPainter& painter, const CurveView& view) {
  static thread_local Backdrop water;
  const RiverColours& colours = river_colours(view.light);
  painter.save();
  painter.setClipRect(view.field);
  water.draw(painter, view.field, view.light,
             [&](QPainter& once, const QRectF& area) { paint_water(once, area, colours); });
  paint_ripples(painter, view);
  paint_bank(painter, view, colours, true);
  paint_bank(painter, view, colours, false);
  painter.setPen(QPen(QColor(255, 255, 255, 170), 0.006 * view.field.height()));
  painter.drawLine(QPointF(view.field.left(), view.zero_y),
                   QPointF(view.field.right(), view.zero_y));
  paint_fairway(painter, view, colours);
  paint_buoys(painter, view);
  if (view.mark_shown) paint_boat(painter, view);
  painter.restore();
}

}  // namespace isograsp::gui
