// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_directions.hpp"

#include <QObject>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <vector>

#include "gui/look/look.hpp"
#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/words/cue_words.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

void draw_mark(QPainter& painter, const QPointF& centre, double radius, bool pulls) {
  if (!pulls) return painter.drawEllipse(centre, radius, radius);
  painter.drawPolygon(polygon({centre + QPointF(0, -radius), centre + QPointF(radius, 0),
                               centre + QPointF(0, radius), centre + QPointF(-radius, 0)}));
}

/// Head and shoulders: this side of the pad is the person's.
void draw_person(QPainter& painter, const QPointF& centre, double size) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(kSoftInk);
  painter.drawEllipse(centre + QPointF(0, -0.28 * size), 0.20 * size, 0.20 * size);
  QPainterPath shoulders;
  shoulders.moveTo(centre + QPointF(-0.42 * size, 0.46 * size));
  shoulders.cubicTo(centre + QPointF(-0.40 * size, -0.12 * size),
                    centre + QPointF(0.40 * size, -0.12 * size),
                    centre + QPointF(0.42 * size, 0.46 * size));
  painter.drawPath(shoulders);
}

void draw_pad(QPainter& painter, const QRectF& pad, Finger finger, const PatientPicture& picture) {
  const DigitPicture& digit = picture.digits[index_of(finger)];
  const double half = 0.5 * pad.width();
  painter.setPen(QPen(kSoftInk, 3));
  painter.setBrush(Qt::white);
  painter.drawRoundedRect(pad, 0.12 * half, 0.12 * half);
  painter.setPen(QPen(kFaint, 2));
  painter.drawLine(QPointF(pad.left(), pad.center().y()), QPointF(pad.right(), pad.center().y()));
  painter.drawLine(QPointF(pad.center().x(), pad.top()), QPointF(pad.center().x(), pad.bottom()));
  const auto place = [&](const PadMark& mark) {
    return pad.center() + half * QPointF(mark.x, -mark.y);
  };
  const PadMark target = mark_on_pad(digit.target_C, picture.digits_N);
  // A hollow ring whose inner edge is the size asked for.
  const double ring = 0.09 * half;
  painter.setPen(QPen(kBandEdge, ring + 6));
  painter.setBrush(Qt::white);
  draw_mark(painter, place(target), half * target.radius + 0.5 * ring, target.pulls);
  painter.setPen(QPen(kBand, ring));
  draw_mark(painter, place(target), half * target.radius + 0.5 * ring, target.pulls);
  if (picture.force_shown) {
    const PadMark own = mark_on_pad(digit.force_C, picture.digits_N);
    const double radius = half * own.radius;
    if (digit.on_target && !own.pulls) {
      paint_check(painter, place(own), radius);
    } else {
      painter.setPen(QPen(Qt::white, 3));
      painter.setBrush(digit.on_target ? kGood : kDot);
      draw_mark(painter, place(own), radius, own.pulls);
    }
  }
  const double side = plus_y_is_toward(finger, picture.hand) ? 1.0 : -1.0;
  const double size = 0.36 * half;
  draw_person(painter, pad.center() + QPointF(side * (half + 0.62 * size), 0), size);
}

}  // namespace

PadMark mark_on_pad(const Vec3& force_C, double full_N) noexcept {
  constexpr double kSmallest = 0.09;  ///< no force at all is still seen
  constexpr double kLargest = 0.52;
  const double full = full_N > 0.0 ? full_N : 1.0;
  const ForceAxis sideways{-full, full};
  const ForceAxis depth{0.0, full};
  const double at_rest = depth.share(0.0);
  const auto along = [&](double force_N) { return 2.0 * sideways.share(force_N) - 1.0; };
  PadMark mark;
  mark.x = along(force_C.y());
  mark.y = along(force_C.x());
  mark.radius = kSmallest + (kLargest - kSmallest) *
                                (depth.share(std::abs(force_C.z())) - at_rest) / (1.0 - at_rest);
  // Sensor noise around zero must not change the shape back and forth.
  constexpr double kPulls = 0.05;
  mark.pulls = force_C.z() < -kPulls * full;
  return mark;
}

void paint_directions(QPainter& painter, const QRectF& field, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  // As the hand stands: the thumb at one side, the index above the middle finger at the other.
  std::vector<Finger> order;
  for (const Finger finger : kFingers)
    if (picture.digits[index_of(finger)].asked) order.push_back(finger);
  if (order.empty()) return;
  if (picture.hand == Hand::left && order.front() == Finger::thumb)
    std::rotate(order.begin(), order.begin() + 1, order.end());
  const auto count = static_cast<double>(order.size());
  const double title = order.size() > 1 ? 0.13 * field.height() : 0.0;  // one is in the headline
  const double size = std::min(field.height() - title, 0.70 * field.width() / count);
  const double top = field.top() + 0.5 * (field.height() - title - size);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const double middle = field.left() + field.width() * (static_cast<double>(i) + 0.5) / count;
    const QRectF pad(middle - 0.5 * size, top + title, size, size);
    draw_pad(painter, pad, order[i], picture);
    if (title > 0.0)
      draw_line(painter, field, QRectF(pad.left(), top, size, 0.9 * title), finger_title(order[i]),
                0.11, true, kInk);
  }
}

}  // namespace isograsp::gui
