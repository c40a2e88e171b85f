// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_signs.hpp"

#include <QPainterPath>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/words/cue_words.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

using Asked = std::array<bool, kFingerCount>;

constexpr double kStroke = 6.0;

void draw_arrow(QPainter& painter, QPointF from, QPointF to, double width = kStroke) {
  painter.setPen(QPen(kDot, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawLine(from, to);
  const QPointF along = (to - from) / std::hypot(to.x() - from.x(), to.y() - from.y());
  const QPointF across(-along.y(), along.x());
  const double head = 2.2 * width;
  painter.drawPolyline(polygon({to - head * (along - across), to, to - head * (along + across)}));
}

/// The arrow is larger toward the person and smaller away from them, as in perspective.
void draw_depth_arrow(QPainter& painter, bool toward) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(kDot);
  if (toward)
    painter.drawPolygon(
        polygon({{44, 12}, {56, 12}, {63, 52}, {84, 52}, {50, 92}, {16, 52}, {37, 52}}));
  else
    painter.drawPolygon(
        polygon({{26, 92}, {74, 92}, {59, 40}, {70, 40}, {50, 12}, {30, 40}, {41, 40}}));
}

/// A right hand seen from above, fingers up; `stretch` 1: open, 0: a fist. Asked digits are filled.
/// On a grid of 100 x 100.
void draw_hand(QPainter& painter, double stretch, const Asked& asked = {}) {
  painter.setPen(QPen(kDot, 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::white);
  QPainterPath hand;
  hand.addRoundedRect(QRectF(28, 46, 46, 44), 16, 16);
  constexpr std::array<double, 4> kLength{32, 40, 37, 26};
  QPainterPath filled;
  for (std::size_t i = 0; i < kLength.size(); ++i) {
    const double length = 14 + (kLength[i] + 4 - 14) * stretch;
    QPainterPath finger;
    finger.addRoundedRect(QRectF(28 + 11.6 * static_cast<double>(i), 58 - length, 11.2, length + 6),
                          5.6, 5.6);
    hand = hand.united(finger);
    if (i < 2 && asked[i + 1]) filled.addPath(finger);  // index, middle
  }
  QPainterPath thumb;
  thumb.addRoundedRect(QRectF(-6, -26 * (0.55 + 0.45 * stretch), 12, 36), 6, 6);
  QTransform turn;
  turn.translate(33, 74);
  turn.rotate(-46);
  hand = hand.united(turn.map(thumb));
  if (asked[0]) filled.addPath(turn.map(thumb));
  painter.drawPath(hand);
  painter.setBrush(kDot);
  painter.drawPath(filled);
}

void mirror(QPainter& painter, Hand hand) {
  if (hand == Hand::right) return;
  painter.translate(100, 0);
  painter.scale(-1, 1);
}

/// Digits of a channel that is not taken from the whole hand.
Asked asked_of(ForceChannel channel) {
  Asked asked{};
  if (const auto finger = single_digit(channel)) asked[index_of(*finger)] = true;
  if (channel.digits == Digits::pinch) asked = {true, true, false};
  return asked;
}

/// Thumb and fingers press toward each other and open away from each other.
void draw_hand_act(QPainter& painter, const PatientPicture& picture) {
  const bool closing = picture.channel.direction == Direction::plus_z;
  const Asked asked = asked_of(picture.channel);
  const bool some = asked[0] || asked[1] || asked[2];
  painter.save();
  mirror(painter, picture.hand);
  draw_hand(painter, closing && !some ? 0.0 : 1.0, asked);
  const auto side_arrow = [&](double near, double far, double y) {
    draw_arrow(painter, {closing ? far : near, y}, {closing ? near : far, y});
  };
  if (!some || asked[0])
    side_arrow(some ? -2 : closing ? 14 : 12, some ? -24 : closing ? -8 : -10, 72);
  if (!some || asked[1] || asked[2])
    side_arrow(some ? 84 : closing ? 86 : 88, some ? 106 : closing ? 108 : 110, some ? 26 : 72);
  painter.restore();
}

/// The digit on a small hand, and where it is to go.
void draw_act(QPainter& painter, const PatientPicture& picture) {
  const Direction direction = picture.channel.direction;
  if (is_normal(direction)) return draw_hand_act(painter, picture);
  painter.save();
  painter.translate(-10, 16);
  painter.scale(0.72, 0.72);
  mirror(painter, picture.hand);
  draw_hand(painter, 1.0, asked_of(picture.channel));
  painter.restore();
  const double up = direction == Direction::plus_x ? 1.0 : -1.0;
  if (direction == Direction::plus_x || direction == Direction::minus_x)
    return draw_arrow(painter, {80, 52 + 34 * up}, {80, 52 - 34 * up}, 1.6 * kStroke);
  const Finger finger = single_digit(picture.channel).value_or(Finger::thumb);
  painter.save();
  painter.translate(48, 14);
  painter.scale(0.72, 0.76);
  draw_depth_arrow(painter,
                   (direction == Direction::plus_y) == plus_y_is_toward(finger, picture.hand));
  painter.restore();
}

/// A hand that opens at once.
void draw_let_go(QPainter& painter, Hand hand) {
  painter.save();
  mirror(painter, hand);
  painter.translate(8, 10);
  painter.scale(0.84, 0.84);
  draw_hand(painter, 1.0);
  painter.restore();
  painter.setPen(QPen(kDot, kStroke, Qt::SolidLine, Qt::RoundCap));
  for (const double angle_deg : {-62.0, -31.0, 0.0, 31.0, 62.0}) {
    const double angle = angle_deg * 0.0174532925199433;
    const QPointF ray(std::sin(angle), -std::cos(angle));
    painter.drawLine(QPointF(50, 66) + 62 * ray, QPointF(50, 66) + 74 * ray);
  }
}

/// A closed eye.
void draw_memory(QPainter& painter) {
  painter.setPen(QPen(kDot, kStroke, Qt::SolidLine, Qt::RoundCap));
  painter.setBrush(Qt::NoBrush);
  QPainterPath lid;
  lid.moveTo(12, 42);
  lid.quadTo(50, 84, 88, 42);
  painter.drawPath(lid);
  for (const double x : {-26.0, 0.0, 26.0}) {
    const double y = 63 - 0.016 * x * x;
    painter.drawLine(QPointF(50 + x, y), QPointF(50 + 1.35 * x, y + 15 - 0.004 * x * x));
  }
}

}  // namespace

void paint_sign(QPainter& painter, const QRectF& box, const PatientPicture& picture) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(box.topLeft());
  painter.scale(box.width() / 100.0, box.height() / 100.0);
  switch (picture.sign) {
    case PatientPicture::Sign::wait:
      painter.setPen(Qt::NoPen);
      painter.setBrush(kDot);
      for (const double x : {26.0, 50.0, 74.0}) painter.drawEllipse(QPointF(x, 54), 7.5, 7.5);
      break;
    case PatientPicture::Sign::hand_out:
      painter.save();
      painter.translate(-14, 6);
      draw_hand(painter, 1.0);
      painter.restore();
      draw_arrow(painter, {72, 66}, {104, 66});
      break;
    case PatientPicture::Sign::rest:
      mirror(painter, picture.hand);
      draw_hand(painter, 0.75);
      break;
    case PatientPicture::Sign::act: draw_act(painter, picture); break;
    case PatientPicture::Sign::let_go: draw_let_go(painter, picture.hand); break;
    case PatientPicture::Sign::memory: draw_memory(painter); break;
    case PatientPicture::Sign::good:
      painter.setPen(Qt::NoPen);
      painter.setBrush(kGood);
      painter.drawEllipse(QPointF(50, 54), 38, 38);
      painter.setPen(QPen(Qt::white, 9, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(polygon({{33, 55}, {46, 68}, {69, 41}}));
      break;
  }
  painter.restore();
}

}  // namespace isograsp::gui
