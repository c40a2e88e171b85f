// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/support_picture.hpp"

#include <QPainter>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/words/texts.hpp"

namespace isograsp::gui {

namespace {

/// Where a support stands, in shares of the picture's height from its middle: x to the right, y
/// down. The thumb is on the side of the other hand; index above middle.
QPointF place_of(Finger finger, Hand hand) {
  const double side = (finger == Finger::thumb) == (hand == Hand::right) ? -1.0 : 1.0;
  const double y = finger == Finger::thumb ? 0.0 : finger == Finger::index ? -0.17 : 0.17;
  return {0.30 * side, y};
}

/// Where an arrow points in the picture. Toward the wrist is toward whoever looks: down and large.
QPointF direction_of(Press press, Finger finger, Hand hand) {
  switch (press) {
    case Press::up: return {0.0, -1.0};
    case Press::toward_wrist: return {0.0, 1.0};
    case Press::into:
    case Press::weight: break;
  }
  return {place_of(finger, hand).x() < 0.0 ? 1.0 : -1.0, 0.0};
}

void draw_arrow(QPainter& painter, const QPointF& tip, const QPointF& direction, double length,
                const QColor& colour) {
  const QPointF across(-direction.y(), direction.x());
  const double head = 0.35 * length;
  painter.setPen(QPen(colour, 0.12 * length, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(tip - length * direction, tip - 0.9 * head * direction);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawPolygon(polygon({tip, tip - head * direction + 0.5 * head * across,
                               tip - head * direction - 0.5 * head * across}));
}

}  // namespace

SupportPicture::SupportPicture(QWidget* parent) : QWidget(parent) {
  setMinimumSize(scaled(220), scaled(180));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void SupportPicture::show_step(std::optional<CheckStep> step, Hand hand) {
  step_ = step;
  hand_ = hand;
  setAccessibleName(step ? translated(step->instruction())
                         : tr("The three supports, none to be pressed"));
  update();
}

void SupportPicture::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double unit = std::min<double>(height(), width() / 1.3);
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QRectF platform(middle.x() - 0.13 * unit, middle.y() - 0.36 * unit, 0.26 * unit,
                        0.72 * unit);
  painter.setPen(QPen(look::kLine, 1.5));
  painter.setBrush(look::kBackground);
  painter.drawRoundedRect(platform, 0.03 * unit, 0.03 * unit);
  for (const Finger finger : kFingers) {
    const bool asked = step_ && step_->finger == finger;
    const QPointF place = middle + unit * place_of(finger, hand_);
    const QColor colour = look::kFingers[index_of(finger)];
    const bool left = place.x() < middle.x();
    // A pad that faces the platform, on its arm.
    painter.setPen(QPen(look::kQuietText, 0.02 * unit));
    painter.drawLine(place, QPointF(left ? platform.left() : platform.right(), place.y()));
    const QRectF pad(place.x() - 0.02 * unit, place.y() - 0.07 * unit, 0.04 * unit, 0.14 * unit);
    painter.setPen(Qt::NoPen);
    painter.setBrush(asked ? colour : look::kLine);
    painter.drawRoundedRect(pad, 0.02 * unit, 0.02 * unit);
    QFont font = painter.font();
    font.setBold(asked);
    painter.setFont(font);
    painter.setPen(asked ? colour : look::kQuietText);
    // Above the pad: arrows come from the sides.
    const QRectF label(place.x() - 0.15 * unit, place.y() - 0.16 * unit, 0.30 * unit, 0.08 * unit);
    painter.drawText(label, Qt::AlignCenter, finger_title(finger));
    if (!asked) continue;
    const QPointF direction = direction_of(step_->press, finger, hand_);
    const bool into = direction.y() == 0.0;
    const double outside = left ? -1.0 : 1.0;
    const QPointF tip = into
                            ? place - 0.03 * unit * direction
                            : place + QPointF(0.14 * outside * unit, 0.0) + 0.12 * unit * direction;
    draw_arrow(painter, tip, direction, 0.22 * unit, look::kAccent);
  }
}

}  // namespace isograsp::gui
