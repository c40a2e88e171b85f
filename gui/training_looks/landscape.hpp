// SPDX-License-Identifier: GPL-3.0-or-later
// Inside gui/training_looks only: what landscapes have in common.
#pragma once

#include <QColor>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>
#include <cstdint>
#include <functional>

#include "gui/training_looks/curve_view.hpp"

namespace isograsp::gui::landscape {

/// Of three lights the one that shines.
template <class T>
[[nodiscard]] const T& in(tasks::Daylight light, const T& morning, const T& day, const T& evening) {
  return light == tasks::Daylight::morning ? morning
         : light == tasks::Daylight::day   ? day
                                           : evening;
}

/// The same number, 0 … 1, for the same place: nothing is drawn by chance.
[[nodiscard]] double scattered(std::int64_t place, int salt) noexcept;

/// What stands still, painted once for each size and light.
class Backdrop {
 public:
  using Paint = std::function<void(QPainter& painter, const QRectF& area)>;
  void draw(QPainter& painter, const QRectF& field, tasks::Daylight light, const Paint& paint);

 private:
  QImage image_;
  tasks::Daylight light_ = tasks::Daylight::day;
};

/// What moves as a whole, painted once for each size.
class Sprite {
 public:
  using Paint = void (*)(QPainter& painter);
  /// `paint` draws in units of `unit_px` round the origin, no farther than kReach of them.
  void draw(QPainter& painter, const QPointF& at, double unit_px, Paint paint);

 private:
  static constexpr double kReach = 4.5;
  QImage image_;
  double unit_px_ = 0.0;
};

/// The stripe so far to either side of a line.
[[nodiscard]] QPolygonF stripe(const QPolygonF& line, double half_px);
[[nodiscard]] QPolygonF shifted(const QPolygonF& line, double down_px);
[[nodiscard]] QColor mixed(const QColor& a, const QColor& b, double share);
/// The band about a line: within its edges, and with a shade so far beyond them.
struct WayColours {
  QColor shade, edge, way;
};
void paint_way(QPainter& painter, const CurveView& view, const QPolygonF& line, double shade_px,
               const WayColours& colours);
/// A dash every quarter of a second, which goes with the line.
void paint_dashes(QPainter& painter, const CurveView& view, const QPolygonF& line);
/// How steeply the target runs at the mark, clockwise; 0 where there is none.
[[nodiscard]] double heading_deg(const CurveView& view);
/// Where the own force is, to the pixel: a dot, on the target a check, told without a colour.
void paint_own(QPainter& painter, const CurveView& view, double radius_px);

}  // namespace isograsp::gui::landscape
