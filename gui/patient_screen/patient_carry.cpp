// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/patient_screen/patient_tray.hpp"
#include "gui/training_looks/flat_props.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

constexpr double kPointShare = 0.45;  // of the box: the size of a hand

/// From metres of the scene to the screen.
struct PlaneView {
  QPointF middle;
  Vec3 middle_W = Vec3::Zero();
  double scale = 1.0;  ///< of a metre
  [[nodiscard]] QPointF at(const Vec3& p_W) const {
    return {middle.x() + scale * (p_W.x() - middle_W.x()),
            middle.y() - scale * (p_W.y() - middle_W.y())};
  }
};

PlaneView plane_view(const QRectF& area, const CarryPicture& carry) {
  PlaneView view{area.center(), 0.5 * (carry.low_W + carry.high_W)};
  const Vec3 size_m = carry.high_W - carry.low_W;
  view.scale = std::min(area.width() / size_m.x(), area.height() / size_m.y());
  return view;
}

QRectF box_at(const PlaneView& view, const Vec3& p_W, const Vec3& size_m) {
  const double width = view.scale * size_m.x(), height = view.scale * size_m.y();
  return {view.at(p_W) - QPointF(width / 2, height / 2), QSizeF(width, height)};
}

/// How far a hand reaches; pressed beyond its edge the bubble moves, its edge is thick then.
void draw_bubble(QPainter& painter, const PlaneView& view, const CarryPicture& carry, Hand hand) {
  const CarryPicture::Point& of = carry.of[hand];
  const QRectF bubble = box_at(view, of.bubble_W, 2.0 * carry.half_size_m);
  painter.setPen(QPen(hand == Hand::left ? kLeftHand : kRightHand, of.beyond ? 6 : 2,
                      hand == Hand::left ? Qt::DashLine : Qt::SolidLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(bubble);
}

void draw_place(QPainter& painter, const PlaneView& view, const CarryPicture& carry) {
  const Vec3 more = Vec3::Constant(2.0 * carry.tolerance_m);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(kBand.red(), kBand.green(), kBand.blue(), 150));
  painter.drawRect(box_at(view, carry.target_W, carry.size_m + more));
  painter.setPen(QPen(kBandEdge, 5, Qt::DashLine));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box_at(view, carry.target_W, carry.size_m));
}

void draw_box(QPainter& painter, const PlaneView& view, const CarryPicture& carry,
              tasks::Look look) {
  painter.save();
  painter.translate(view.at(carry.p_W));
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  painter.rotate(-kDegrees * carry.angle_rad);
  const double width = view.scale * carry.size_m.x(), height = view.scale * carry.size_m.y();
  const QRectF box(-width / 2, -height / 2, width, height);
  if (look == tasks::Look::crate) {
    paint_crate(painter, box, carry.held, carry.on_target);
  } else {
    painter.setPen(QPen(kInk, carry.held ? 6 : 3));
    painter.setBrush(carry.on_target ? kGood : QColor(Qt::white));
    painter.drawRect(box);
  }
  painter.restore();
}

}  // namespace

void paint_carry(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const CarryPicture& carry = *picture.two_hands->carry;
  if (!(carry.size_m.x() > 0.0 && carry.size_m.y() > 0.0)) return;
  const PlaneView view = plane_view(area, carry);
  if (carry.target_shown) draw_place(painter, view, carry);
  for (const Hand hand : kBothHands) draw_bubble(painter, view, carry, hand);
  draw_box(painter, view, carry, picture.look);
  for (const Hand hand : kBothHands)
    paint_hand_mark(painter, box_at(view, carry.of[hand].p_W, kPointShare * carry.size_m), hand);
  if (picture.hold_fraction > 0.0)
    paint_hold_ring(painter, view.at(carry.p_W), 0.3 * view.scale * carry.size_m.y(),
                    picture.hold_fraction);
}

}  // namespace isograsp::gui
