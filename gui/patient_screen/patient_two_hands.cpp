// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_two_hands.hpp"

#include <QPainterPath>
#include <algorithm>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/patient_screen/patient_signs.hpp"
#include "gui/patient_screen/patient_tray.hpp"
#include "gui/training_looks/flat_props.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

using Bar = TwoHandsPicture::Bar;
using Side = TwoHandsPicture::Side;

/// Round is the left hand, square the right one.
QPainterPath outline_of(const QRectF& bar, std::optional<Hand> hand) {
  QPainterPath outline;
  if (hand == Hand::left)
    outline.addRoundedRect(bar, bar.width() / 2, bar.width() / 2);
  else
    outline.addRect(bar);
  return outline;
}

/// Plain is the right hand, striped the left one.
void fill_part(QPainter& painter, const QRectF& filled, Hand hand) {
  if (hand == Hand::right) return painter.fillRect(filled, kRightHand);
  painter.save();
  painter.setClipRect(filled, Qt::IntersectClip);
  painter.fillRect(filled, Qt::white);
  const double apart = filled.width() / 6.0;
  painter.setPen(QPen(kLeftHand, 0.42 * apart));
  for (double y = filled.bottom() + filled.width(); y > filled.top(); y -= apart)
    painter.drawLine(QPointF(filled.left(), y), QPointF(filled.right(), y - filled.width()));
  // Where it ends is to be seen as well as the end of a plain one.
  painter.fillRect(QRectF(filled.topLeft(), QSizeF(filled.width(), 0.06 * filled.width())),
                   kLeftHand);
  painter.restore();
}

/// From the bottom of `bar`, between two shares of its height.
QRectF filled(const QRectF& bar, double from, double to) {
  return {bar.left(), bar.bottom() - to * bar.height(), bar.width(), (to - from) * bar.height()};
}

void draw_target(QPainter& painter, const QRectF& bar, const Bar& asked) {
  const double beyond = 0.16 * bar.width();
  const double middle = bar.bottom() - asked.target * bar.height();
  const double half = asked.half_band * bar.height();
  const QRectF band(bar.left() - beyond, middle - half, bar.width() + 2 * beyond, 2 * half);
  painter.setPen(QPen(kBandEdge, 2));
  painter.setBrush(QColor(kBand.red(), kBand.green(), kBand.blue(), 150));
  painter.drawRect(band);
  painter.setPen(QPen(kBandEdge, 5));
  painter.drawLine(QPointF(band.left(), middle), QPointF(band.right(), middle));
}

template <class Fill>
void draw_bar(QPainter& painter, const QRectF& bar, const Bar& shown, std::optional<Hand> hand,
              Fill fill) {
  const QPainterPath outline = outline_of(bar, hand);
  painter.fillPath(outline, Qt::white);
  if (shown.force_shown) {
    painter.save();
    painter.setClipPath(outline, Qt::IntersectClip);
    fill();
    painter.restore();
  }
  painter.setPen(QPen(kSoftInk, 3));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
  if (shown.target_shown) draw_target(painter, bar, shown);
  if (shown.on_target)
    paint_check(painter, {bar.center().x(), bar.bottom() - shown.force * bar.height()},
                0.30 * bar.width());
}

void draw_sign(QPainter& painter, const QRectF& box, Hand hand, bool works) {
  PatientPicture sign;
  sign.sign = works ? PatientPicture::Sign::act : PatientPicture::Sign::rest;
  sign.hand = hand;
  paint_sign(painter, box, sign);
}

/// In a column: the bar, or a large sign where there is none; below it sign, name and act.
void draw_side(QPainter& painter, const QRectF& area, const QRectF& column, Hand hand,
               const Side& side) {
  const double h = area.height();
  const auto at = [&](double share) { return area.top() + share * h; };
  const bool bar = side.bar.force_shown || side.bar.target_shown;
  const double size = (bar ? 0.105 : 0.30) * h;
  const double top = at(bar ? 0.735 : 0.40);
  if (bar) {
    const double width = 0.15 * h;
    const QRectF place(column.center().x() - width / 2, at(0.295), width, 0.42 * h);
    draw_bar(painter, place, side.bar, hand,
             [&] { fill_part(painter, filled(place, 0.0, side.bar.force), hand); });
  }
  draw_sign(painter, QRectF(column.center().x() - size / 2, top, size, size), hand, side.works);
  const auto line = [&](double from, double to) {
    return QRectF(column.left(), at(from), column.width(), (to - from) * h);
  };
  draw_line(painter, area, line(0.845, 0.895), QString::fromStdString(side.name), 0.045, true,
            hand == Hand::left ? kLeftHand : kRightHand);
  draw_line(painter, area, line(0.895, 0.943), QString::fromStdString(side.act), 0.040, side.works,
            side.works ? kInk : kSoftInk);
}

void draw_sum(QPainter& painter, const QRectF& area, const QRectF& column,
              const TwoHandsPicture& both) {
  const double h = area.height();
  const double width = 0.19 * h;
  const QRectF place(column.center().x() - width / 2, area.top() + 0.295 * h, width, 0.53 * h);
  draw_bar(painter, place, *both.sum, std::nullopt, [&] {
    const double all = both.sum->force;
    if (!both.left_of_sum) return painter.fillRect(filled(place, 0.0, all), kSoftInk);
    const double left = *both.left_of_sum * all;
    fill_part(painter, filled(place, left, all), Hand::right);
    fill_part(painter, filled(place, 0.0, left), Hand::left);
  });
  draw_line(painter, area, QRectF(column.left(), area.top() + 0.845 * h, column.width(), 0.05 * h),
            QString::fromStdString(both.sum_name), 0.045, true, kInk);
}

}  // namespace

void paint_two_hands(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const TwoHandsPicture& both = *picture.two_hands;
  if (both.tray || both.carry) {
    if (picture.look != tasks::Look::plain)
      paint_flat_room(painter, part(area, 0.0, 0.27, 1.0, 0.935), picture.light);
    const QRectF middle = part(area, 0.16, 0.25, 0.84, 0.90);
    if (both.tray)
      paint_tray(painter, middle, picture);
    else
      paint_carry(painter, middle, picture);
    paint_target_marks(painter,
                       {area.left() + 0.06 * area.height(), area.top() + 0.27 * area.height()},
                       0.017 * area.height(), picture);
    return;
  }
  // Nearer to the middle where nothing stands there.
  const double left = both.sum ? 0.05 : 0.14;
  constexpr double kColumn = 0.30;
  draw_side(painter, area, part(area, left, 0.0, left + kColumn, 1.0), Hand::left, both.of.left);
  draw_side(painter, area, part(area, 1.0 - left - kColumn, 0.0, 1.0 - left, 1.0), Hand::right,
            both.of.right);
  if (both.sum) draw_sum(painter, area, part(area, 0.35, 0.0, 0.65, 1.0), both);
}

}  // namespace isograsp::gui
