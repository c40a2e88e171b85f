// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/patient_screen/patient_tray.hpp"

#include <algorithm>
#include <numbers>

#include "gui/patient_screen/patient_canvas.hpp"
#include "gui/patient_screen/patient_ink.hpp"
#include "gui/training_looks/flat_props.hpp"

namespace isograsp::gui {

using namespace ink;

namespace {

constexpr double kRoomAbove = 2.5;    // widths of the band that stay free above it …
constexpr double kRoomBeside = 0.75;  // … and lengths of the tray from the middle to either side

/// From metres of the scene to the screen.
struct View {
  QRectF area;
  double scale = 1.0;  ///< of a metre
  double floor_m = 0.0;
  [[nodiscard]] QPointF at(const Vec3& p_W) const {
    return {area.center().x() + scale * p_W.x(), area.bottom() - scale * (p_W.y() - floor_m)};
  }
};

View view_of(const QRectF& area, const TrayPicture& tray) {
  View view{area};
  view.floor_m = tray.rest_y_m - tray.size_m.y();
  const double top_m =
      std::max(tray.target_y_m, tray.rest_y_m) + kRoomAbove * tray.band_m + tray.size_m.y();
  view.scale = std::min(area.height() / (top_m - view.floor_m),
                        area.width() / (2.0 * kRoomBeside * tray.size_m.x()));
  return view;
}

void draw_rest(QPainter& painter, const View& view, const TrayPicture& tray) {
  const double y_m = tray.rest_y_m - 0.5 * tray.size_m.y();
  const double half_m = 0.62 * tray.size_m.x();
  painter.setPen(QPen(kSoftInk, 6, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(view.at({-half_m, y_m, 0.0}) + QPointF(0, 4),
                   view.at({half_m, y_m, 0.0}) + QPointF(0, 4));
}

/// Where the middle of the tray is to be: its line, and how far it may be off.
void draw_height_band(QPainter& painter, const View& view, const TrayPicture& tray) {
  const double half_m = 0.72 * tray.size_m.x();
  const QPointF low = view.at({-half_m, tray.target_y_m - tray.band_m, 0.0});
  const QPointF high = view.at({half_m, tray.target_y_m + tray.band_m, 0.0});
  painter.setPen(QPen(kBandEdge, 2));
  painter.setBrush(QColor(kBand.red(), kBand.green(), kBand.blue(), 150));
  painter.drawRect(QRectF(QPointF(low.x(), high.y()), QPointF(high.x(), low.y())));
  painter.setPen(QPen(kBandEdge, 5, Qt::DashLine));
  painter.drawLine(view.at({-half_m, tray.target_y_m, 0.0}),
                   view.at({half_m, tray.target_y_m, 0.0}));
}

/// Its colour says what its place says too: it is in the band and level.
void draw_tray(QPainter& painter, const View& view, const TrayPicture& tray, tasks::Look look) {
  painter.save();
  painter.translate(view.at(tray.p_W));
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  painter.rotate(-kDegrees * tray.angle_rad);
  const double half = 0.5 * view.scale * tray.size_m.x();
  const double thick = view.scale * tray.size_m.y();
  const double rim = 0.9 * thick;
  const QRectF board(-half, -0.5 * thick, 2.0 * half, thick);
  if (look == tasks::Look::tea_tray) {
    paint_tea_tray(painter, board, tray.on_target);
    return painter.restore();
  }
  painter.setPen(QPen(kInk, 3));
  painter.setBrush(tray.on_target ? kGood : QColor(Qt::white));
  painter.drawRect(board);
  painter.setBrush(Qt::white);  // a glass in the middle: it shows how the tray hangs
  const double glass = 0.8 * thick;
  painter.drawRect(QRectF(-0.5 * glass, -0.5 * thick - 1.6 * rim, glass, 1.6 * rim));
  painter.restore();
}

/// Off the tray it stands beside its end.
void draw_lifting_hand(QPainter& painter, const View& view, const TrayPicture& tray, Hand hand) {
  const TrayPicture::End& end = tray.of[hand];
  const double side = hand == Hand::left ? -1.0 : 1.0;
  const double size = 2.4 * view.scale * tray.size_m.y();
  const double away = end.touches ? 0.0 : 0.6 * size;
  const QPointF at = view.at(end.p_W) + QPointF(side * (0.5 * size + away), 0.0);
  const QRectF box(at.x() - size / 2, at.y() - size / 2, size, size);
  paint_hand_mark(painter, box, hand);
  if (!end.slips) return;
  // Two strokes beside the hand: it slides up along the end.
  painter.setPen(QPen(kInk, 5, Qt::SolidLine, Qt::RoundCap));
  for (const double offset : {0.75, 1.0}) {
    const double x = at.x() + side * offset * size;
    painter.drawLine(QPointF(x, at.y() - 0.4 * size), QPointF(x, at.y() + 0.4 * size));
  }
}

}  // namespace

void paint_hand_mark(QPainter& painter, const QRectF& box, Hand hand) {
  painter.setPen(QPen(hand == Hand::left ? kLeftHand : kRightHand, 4));
  if (hand == Hand::left) {
    painter.setBrush(Qt::white);
    painter.drawEllipse(box);
    painter.setBrush(QBrush(kLeftHand, Qt::BDiagPattern));
    painter.drawEllipse(box);
  } else {
    painter.setBrush(kRightHand);
    painter.drawRect(box);
  }
}

void paint_tray(QPainter& painter, const QRectF& area, const PatientPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing);
  const TrayPicture& tray = *picture.two_hands->tray;
  if (!(tray.size_m.x() > 0.0 && tray.size_m.y() > 0.0)) return;
  const View view = view_of(area, tray);
  draw_rest(painter, view, tray);
  if (tray.target_shown) draw_height_band(painter, view, tray);
  draw_tray(painter, view, tray, picture.look);
  for (const Hand hand : kBothHands) draw_lifting_hand(painter, view, tray, hand);
  if (picture.hold_fraction > 0.0)
    paint_hold_ring(painter, view.at(tray.p_W) - QPointF(0.0, 4.2 * view.scale * tray.size_m.y()),
                    1.2 * view.scale * tray.size_m.y(), picture.hold_fraction);
}

}  // namespace isograsp::gui
