// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_range.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gui/patient_screen/patient_ink.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

constexpr double kFullTurn_deg = 360.0;
constexpr double kDialHalf_deg = 135.0;  ///< to either side of zero, which is at the top
constexpr double kTick_deg = 45.0;
constexpr double kQtDegree = 16.0;  ///< QPainter counts sixteenths

double degrees_of(double angle_rad) {
  return std::clamp(angle_rad * 180.0 / std::numbers::pi, -kDialHalf_deg, kDialHalf_deg);
}

}  // namespace

void paint_range(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  // On the screen positive angles go counterclockwise, as Qt counts them.
  const double sign = picture.hand == Hand::right ? 1.0 : -1.0;
  constexpr double kTop_deg = 90.0;
  const double radius = 0.5 * std::min(area.width(), 1.08 * area.height());
  const double width = 0.20 * radius;
  const QPointF centre(area.center().x(), area.top() + radius);
  const QRectF box(centre.x() - radius + width / 2, centre.y() - radius + width / 2,
                   2 * radius - width, 2 * radius - width);
  const auto draw_arc = [&](double from_deg, double to_deg, const QColor& colour) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(box, static_cast<int>(kQtDegree * (kTop_deg + sign * from_deg)),
                    static_cast<int>(kQtDegree * sign * (to_deg - from_deg)));
  };
  const auto at = [&](double angle_deg, double distance) {
    const double a = (kTop_deg + sign * angle_deg) * 2.0 * std::numbers::pi / kFullTurn_deg;
    return centre + distance * QPointF(std::cos(a), -std::sin(a));
  };
  painter.setBrush(Qt::NoBrush);
  draw_arc(-kDialHalf_deg, kDialHalf_deg, kFaint);
  const ShownAngle& angle = picture.angle;
  if (angle.ranged) {
    draw_arc(degrees_of(angle.least_rad), degrees_of(angle.largest_rad), kBand);
    painter.setPen(QPen(kBandEdge, 0.03 * radius, Qt::SolidLine, Qt::FlatCap));
    for (const double end_rad : {angle.least_rad, angle.largest_rad}) {
      const double end_deg = degrees_of(end_rad);
      painter.drawLine(at(end_deg, radius - width), at(end_deg, radius));
    }
  }
  painter.setPen(QPen(kZero, 3));
  for (double tick_deg = -kDialHalf_deg; tick_deg <= kDialHalf_deg; tick_deg += kTick_deg)
    painter.drawLine(at(tick_deg, radius - width - 0.05 * radius), at(tick_deg, radius - width));
  if (!angle.seen) return;
  const double now_deg = degrees_of(angle.now_rad);
  painter.setPen(QPen(kDot, 0.07 * radius, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centre, at(now_deg, radius - 0.5 * width));
  painter.setPen(Qt::NoPen);
  painter.setBrush(kDot);
  painter.drawEllipse(centre, 0.09 * radius, 0.09 * radius);
}

}  // namespace isograsp::gui
