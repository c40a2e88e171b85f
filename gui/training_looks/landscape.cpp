// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training_looks/landscape.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace isograsp::gui::landscape {

double scattered(std::int64_t place, int salt) noexcept {
  auto bits = static_cast<std::uint64_t>(place) * 0x9E3779B97F4A7C15ULL +
              static_cast<std::uint64_t>(salt) * 0xD1B54A32D192ED03ULL;
  bits ^= bits >> 31U;
  bits *= 0xBF58476D1CE4E5B9ULL;
  bits ^= bits >> 29U;
  constexpr double kRange = 16777216.0;
  return static_cast<double>(bits >> 40U) / kRange;
}

void Backdrop::draw(QPainter& painter, const QRectF& field, tasks::Daylight light,
                    const Paint& paint) {
  const QSize size = field.toAlignedRect().size();
  if (image_.size() != size || light_ != light) {
    image_ = QImage(size, QImage::Format_RGB32);
    light_ = light;
    QPainter once(&image_);
    once.setRenderHint(QPainter::Antialiasing);
    paint(once, QRectF(QPointF(0, 0), QSizeF(size)));
  }
  painter.drawImage(field.toAlignedRect().topLeft(), image_);
}

QPolygonF stripe(const QPolygonF& line, double half_px) {
  QPolygonF all = shifted(line, -half_px);
  for (auto point = line.rbegin(); point != line.rend(); ++point)
    all.append(*point + QPointF(0, half_px));
  return all;
}

void paint_way(QPainter& painter, const CurveView& view, const QPolygonF& line, double shade_px,
               const WayColours& colours) {
  // Its edges are a wider stripe below it: outlines of so many corners cost more.
  const double edge_px = 0.0025 * view.field.height();
  painter.setPen(Qt::NoPen);
  for (const auto& [half_px, colour] : {std::pair{view.half_band_px + shade_px, colours.shade},
                                        {view.half_band_px + edge_px, colours.edge},
                                        {view.half_band_px - edge_px, colours.way}}) {
    painter.setBrush(colour);
    painter.drawPolygon(stripe(line, half_px));
  }
}

QPolygonF shifted(const QPolygonF& line, double down_px) {
  return line.translated(0, down_px);
}

QColor mixed(const QColor& a, const QColor& b, double share) {
  const auto mix = [share](double from, double to) { return from + share * (to - from); };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()),
                          mix(a.blueF(), b.blueF()), mix(a.alphaF(), b.alphaF()));
}

void Sprite::draw(QPainter& painter, const QPointF& at, double unit_px, Paint paint) {
  const double reach = kReach * unit_px;
  if (unit_px_ != unit_px) {
    unit_px_ = unit_px;
    const int side = 2 * static_cast<int>(std::ceil(reach));
    image_ = QImage(side, side, QImage::Format_ARGB32_Premultiplied);
    image_.fill(Qt::transparent);
    QPainter once(&image_);
    once.setRenderHint(QPainter::Antialiasing);
    once.translate(side / 2.0, side / 2.0);
    once.scale(unit_px, unit_px);
    paint(once);
  }
  const QPointF corner = at - QPointF(image_.width() / 2.0, image_.height() / 2.0);
  if (painter.worldTransform().type() <= QTransform::TxTranslate)
    return painter.drawImage(corner.toPoint(), image_);
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(corner, image_);
  painter.restore();
}

void paint_dashes(QPainter& painter, const CurveView& view, const QPolygonF& line) {
  constexpr double kApart_s = 0.12;
  for (int k = 0; k + 1 < line.size(); ++k) {
    const double s = (line[k].x() - view.field.left()) / view.px_per_s + view.begin_s;
    if (s - kApart_s * std::floor(s / kApart_s) < 0.45 * kApart_s)
      painter.drawLine(line[k], line[k + 1]);
  }
}

double heading_deg(const CurveView& view) {
  for (const QPolygonF& line : view.targets)
    for (int k = 0; k + 1 < line.size(); ++k)
      if (line[k].x() <= view.mark.x() && view.mark.x() < line[k + 1].x()) {
        const QPointF way = line[k + 1] - line[k];
        return std::atan2(way.y(), way.x()) * 180.0 / std::numbers::pi;
      }
  return 0.0;
}

void paint_own(QPainter& painter, const CurveView& view, double radius_px) {
  const QPointF& at = view.mark;
  painter.setPen(QPen(Qt::white, 0.28 * radius_px));
  painter.setBrush(view.on_target ? QColor(0x00, 0x66, 0x45) : QColor(0x0B, 0x3F, 0x78));
  const double radius = view.on_target ? 1.25 * radius_px : radius_px;
  painter.drawEllipse(at, radius, radius);
  if (!view.on_target) return;
  painter.setPen(QPen(Qt::white, 0.32 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPolygonF check;
  check << at + radius * QPointF(-0.46, 0.03) << at + radius * QPointF(-0.12, 0.37)
        << at + radius * QPointF(0.49, -0.35);
  painter.drawPolyline(check);
}

}  // namespace isograsp::gui::landscape
