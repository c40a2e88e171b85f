// SPDX-License-Identifier: GPL-3.0-or-later
// A wide sky: the band is a lane of bright air, the own force a hot-air balloon in it.
#include <cmath>

#include "gui/training_looks/curve_looks.hpp"
#include "gui/training_looks/landscape.hpp"

namespace isograsp::gui {

namespace {

using namespace landscape;

struct SkyColours {
  QColor top, middle, low, far_hills, hills, near_hills, lane, edge, cloud;
};

const SkyColours& sky_colours(tasks::Daylight light) {
  static const SkyColours kMorning{{0x9F, 0xC4, 0xDD}, {0xD5, 0xE3, 0xE8}, {0xF8, 0xE3, 0xCC},
                                   {0xB9, 0xC9, 0xD3}, {0x93, 0xB0, 0xAE}, {0x6E, 0x94, 0x80},
                                   {0xFF, 0xF8, 0xE6}, {0x8A, 0x63, 0x1E}, {0xFF, 0xFF, 0xFF}};
  static const SkyColours kDay{{0x6F, 0xAE, 0xDC}, {0xA6, 0xCF, 0xEA}, {0xDC, 0xEE, 0xF6},
                               {0xA9, 0xC3, 0xD6}, {0x7F, 0xAA, 0xA2}, {0x55, 0x8A, 0x66},
                               {0xFF, 0xFB, 0xEA}, {0x6B, 0x4E, 0x12}, {0xFF, 0xFF, 0xFF}};
  static const SkyColours kEvening{{0x7C, 0x88, 0xB8}, {0xC6, 0xA9, 0xC0}, {0xF5, 0xC6, 0xA0},
                                   {0x9A, 0x8F, 0xB0}, {0x75, 0x74, 0x96}, {0x54, 0x5E, 0x78},
                                   {0xFF, 0xF0, 0xD8}, {0x6B, 0x3A, 0x1A}, {0xFF, 0xEE, 0xE2}};
  return in(light, kMorning, kDay, kEvening);
}

void paint_sky(QPainter& painter, const QRectF& area, const SkyColours& colours) {
  QLinearGradient up(area.topLeft(), area.bottomLeft());
  up.setColorAt(0.0, colours.top);
  up.setColorAt(0.55, colours.middle);
  up.setColorAt(0.92, colours.low);
  painter.fillRect(area, up);
}

/// Hills in three distances; those farther away go by more slowly.
void paint_hills(QPainter& painter, const CurveView& view, const SkyColours& colours) {
  struct Range {
    const QColor& colour;
    double pace, height, rise, wide;
  };
  const QRectF& field = view.field;
  for (const Range& range : {Range{colours.far_hills, 0.12, 0.17, 0.050, 0.55},
                             Range{colours.hills, 0.28, 0.11, 0.035, 0.8},
                             Range{colours.near_hills, 0.55, 0.055, 0.022, 1.2}}) {
    QPolygonF land;
    land << field.bottomLeft();
    constexpr int kSteps = 48;
    for (int k = 0; k <= kSteps; ++k) {
      const double x = field.left() + field.width() * k / kSteps;
      const double s =
          (range.pace * view.begin_s * view.px_per_s + (x - field.left())) / field.height();
      const double up = range.height + range.rise * std::sin(2.2 * s / range.wide + range.wide) +
                        0.5 * range.rise * std::sin(5.1 * s / range.wide + 4.0 * range.wide);
      land << QPointF(x, field.bottom() - up * field.height());
    }
    land << field.bottomRight();
    painter.setPen(Qt::NoPen);
    painter.setBrush(range.colour);
    painter.drawPolygon(land);
  }
}

void paint_clouds(QPainter& painter, const CurveView& view, const SkyColours& colours) {
  const QRectF& field = view.field;
  constexpr double kApart = 0.42;  // heights of the field
  constexpr double kPace = 0.22;
  const double gone = kPace * view.begin_s * view.px_per_s / field.height();
  const double across = field.width() / field.height();
  painter.setPen(Qt::NoPen);
  for (auto place = static_cast<std::int64_t>(std::floor(gone / kApart)) - 1;
       static_cast<double>(place) * kApart < gone + across + kApart; ++place) {
    if (scattered(place, 5) < 0.30) continue;
    const double x =
        field.left() +
        field.height() * ((static_cast<double>(place) + 0.6 * scattered(place, 6)) * kApart - gone);
    const double y = field.top() + field.height() * (0.06 + 0.55 * scattered(place, 7));
    const double size = field.height() * (0.030 + 0.022 * scattered(place, 8));
    QPainterPath cloud;
    cloud.setFillRule(Qt::WindingFill);
    cloud.addRoundedRect(QRectF(x - 2.6 * size, y - 0.25 * size, 5.2 * size, 0.95 * size),
                         0.47 * size, 0.47 * size);
    cloud.addEllipse(QPointF(x - 0.9 * size, y - 0.20 * size), 0.95 * size, 0.80 * size);
    cloud.addEllipse(QPointF(x + 0.55 * size, y - 0.45 * size), 1.15 * size, 1.05 * size);
    QColor white = colours.cloud;
    white.setAlpha(125);
    painter.setBrush(white);
    painter.drawPath(cloud);
  }
}

void paint_lane(QPainter& painter, const CurveView& view, const SkyColours& colours) {
  const double unit = view.field.height();
  for (const QPolygonF& line : view.targets) {
    if (line.size() < 2) continue;
    paint_way(painter, view, line, 0.013 * unit,
              {mixed(colours.middle, colours.lane, 0.5), colours.edge, colours.lane});
    painter.setPen(QPen(colours.edge, 0.004 * unit, Qt::SolidLine, Qt::RoundCap));
    paint_dashes(painter, view, line);
  }
}

/// The middle of its envelope is the mark.
void draw_balloon(QPainter& painter) {
  const QColor red(0xA8, 0x32, 0x2C);
  const QColor cream(0xF7, 0xE8, 0xC8);
  QPainterPath envelope(QPointF(-0.34, 1.62));
  envelope.cubicTo(QPointF(-0.62, 1.15), QPointF(-1.45, 0.75), QPointF(-1.45, -0.05));
  envelope.cubicTo(QPointF(-1.45, -0.92), QPointF(-0.80, -1.45), QPointF(0.0, -1.45));
  envelope.cubicTo(QPointF(0.80, -1.45), QPointF(1.45, -0.92), QPointF(1.45, -0.05));
  envelope.cubicTo(QPointF(1.45, 0.75), QPointF(0.62, 1.15), QPointF(0.34, 1.62));
  envelope.closeSubpath();
  // Ropes and basket.
  painter.setPen(QPen(QColor(0x4A, 0x2E, 0x17), 0.07));
  for (const double x : {-0.3, 0.3}) painter.drawLine(QPointF(x, 1.6), QPointF(0.8 * x, 2.12));
  painter.setPen(QPen(Qt::white, 0.10));
  painter.setBrush(QColor(0x7C, 0x4A, 0x25));
  painter.drawRoundedRect(QRectF(-0.33, 2.08, 0.66, 0.46), 0.12, 0.12);
  painter.setPen(Qt::NoPen);
  painter.setBrush(red);
  painter.drawPath(envelope);
  // Gores: narrower towards the edge, as they turn away.
  painter.save();
  painter.setClipPath(envelope);
  painter.setBrush(cream);
  for (const auto& [outer, inner] : {std::pair{1.25, 0.80}, {0.36, -0.36}, {-0.80, -1.25}}) {
    QPainterPath gore(QPointF(0.0, -1.47));
    gore.quadTo(QPointF(1.35 * outer, -0.95), QPointF(outer, 0.05));
    gore.quadTo(QPointF(0.75 * outer, 1.0), QPointF(0.25 * outer, 1.7));
    gore.lineTo(QPointF(0.25 * inner, 1.7));
    gore.quadTo(QPointF(0.75 * inner, 1.0), QPointF(inner, 0.05));
    gore.quadTo(QPointF(1.35 * inner, -0.95), QPointF(0.0, -1.47));
    painter.drawPath(gore);
  }
  QRadialGradient round(QPointF(-0.5, -0.65), 2.3);
  round.setColorAt(0.0, QColor(255, 255, 255, 95));
  round.setColorAt(0.45, QColor(255, 255, 255, 0));
  round.setColorAt(1.0, QColor(30, 10, 30, 120));
  painter.setBrush(round);
  painter.drawPath(envelope);
  painter.restore();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::white, 0.12));
  painter.drawPath(envelope);
}

}  // namespace

void paint_balloon(QPainter& painter, const CurveView& view) {
  static thread_local Backdrop sky;
  const SkyColours& colours = sky_colours(view.light);
  painter.save();
  painter.setClipRect(view.field);
  sky.draw(painter, view.field, view.light,
           [&](QPainter& once, const QRectF& area) { paint_sky(once, area, colours); });
  paint_clouds(painter, view, colours);
  paint_hills(painter, view, colours);
  painter.setPen(QPen(QColor(255, 255, 255, 170), 0.006 * view.field.height()));
  painter.drawLine(QPointF(view.field.left(), view.zero_y),
                   QPointF(view.field.right(), view.zero_y));
  paint_lane(painter, view, colours);
  if (view.mark_shown) {
    static thread_local Sprite balloon;
    balloon.draw(painter, view.mark, view.mark_radius_px, draw_balloon);
    paint_own(painter, view, 0.48 * view.mark_radius_px);
  }
  painter.restore();
}

}  // namespace isograsp::gui
