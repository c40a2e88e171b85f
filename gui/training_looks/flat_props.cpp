// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/training_looks/flat_props.hpp"

#include <QLinearGradient>
#include <QPainterPath>
#include <QRadialGradient>
#include <algorithm>

namespace isograsp::gui {

namespace {

const QColor kReached(0x00, 0x66, 0x45);
const QColor kWoodDark(0x8A, 0x5A, 0x2E);
const QColor kContour(0x4A, 0x2E, 0x17);

QLinearGradient wood(const QRectF& board) {
  QLinearGradient down(board.topLeft(), board.bottomLeft());
  down.setColorAt(0.0, QColor(0xE2, 0xBA, 0x86));
  down.setColorAt(1.0, QColor(0xC0, 0x8D, 0x55));
  return down;
}

void paint_apple(QPainter& painter, const QPointF& centre, double radius, bool red) {
  QRadialGradient round(centre - QPointF(0.35 * radius, 0.4 * radius), 1.5 * radius);
  round.setColorAt(0.0, red ? QColor(0xE8, 0x6A, 0x55) : QColor(0xD3, 0xD9, 0x77));
  round.setColorAt(1.0, red ? QColor(0x9C, 0x25, 0x20) : QColor(0x86, 0x96, 0x35));
  painter.setPen(QPen(red ? QColor(0x6E, 0x18, 0x16) : QColor(0x5C, 0x68, 0x22), 0.08 * radius));
  painter.setBrush(round);
  painter.drawEllipse(centre, radius, radius);
  painter.setPen(QPen(kContour, 0.14 * radius, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centre - QPointF(0, 0.85 * radius),
                   centre - QPointF(-0.15 * radius, 1.2 * radius));
}

void paint_cup(QPainter& painter, double left, double floor, double size) {
  QPainterPath cup(QPointF(left, floor - size));
  cup.cubicTo(QPointF(left + 0.05 * size, floor - 0.2 * size), QPointF(left + 0.2 * size, floor),
              QPointF(left + 0.35 * size, floor));
  cup.lineTo(QPointF(left + 0.75 * size, floor));
  cup.cubicTo(QPointF(left + 0.9 * size, floor), QPointF(left + 1.05 * size, floor - 0.2 * size),
              QPointF(left + 1.1 * size, floor - size));
  cup.closeSubpath();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kContour, 0.16 * size));
  painter.drawEllipse(QPointF(left + 1.12 * size, floor - 0.58 * size), 0.24 * size, 0.24 * size);
  painter.setPen(QPen(kContour, 0.07 * size));
  painter.setBrush(QColor(0xFA, 0xF7, 0xF0));
  painter.drawPath(cup);
  painter.setPen(QPen(QColor(0x2B, 0x62, 0x97), 0.10 * size));
  painter.drawLine(QPointF(left + 0.10 * size, floor - 0.78 * size),
                   QPointF(left + 1.0 * size, floor - 0.78 * size));
}

void paint_pot(QPainter& painter, double middle, double floor, double size) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(kContour, 0.13 * size));
  painter.drawEllipse(QPointF(middle - 0.72 * size, floor - 0.58 * size), 0.28 * size, 0.30 * size);
  QPainterPath spout(QPointF(middle + 0.55 * size, floor - 0.35 * size));
  spout.quadTo(QPointF(middle + 0.95 * size, floor - 0.45 * size),
               QPointF(middle + 1.05 * size, floor - 0.98 * size));
  spout.lineTo(QPointF(middle + 0.88 * size, floor - 0.98 * size));
  spout.quadTo(QPointF(middle + 0.80 * size, floor - 0.70 * size),
               QPointF(middle + 0.50 * size, floor - 0.72 * size));
  painter.setPen(QPen(kContour, 0.05 * size));
  painter.setBrush(QColor(0x2B, 0x62, 0x97));
  painter.drawPath(spout);
  QRadialGradient round(QPointF(middle - 0.25 * size, floor - 0.8 * size), 1.3 * size);
  round.setColorAt(0.0, QColor(0x6F, 0xA3, 0xD0));
  round.setColorAt(1.0, QColor(0x1F, 0x4E, 0x7C));
  painter.setBrush(round);
  QPainterPath body;
  body.addEllipse(QPointF(middle, floor - 0.55 * size), 0.74 * size, 0.55 * size);
  painter.drawPath(body);
  painter.setBrush(QColor(0x2B, 0x62, 0x97));
  painter.drawRoundedRect(
      QRectF(middle - 0.36 * size, floor - 1.14 * size, 0.72 * size, 0.14 * size), 0.07 * size,
      0.07 * size);
  painter.drawEllipse(QPointF(middle, floor - 1.22 * size), 0.10 * size, 0.10 * size);
}

}  // namespace

void paint_flat_room(QPainter& painter, const QRectF& area, tasks::Daylight light) {
  static const QColor kWalls[3][2] = {{{0xF5, 0xEE, 0xDF}, {0xE8, 0xDD, 0xC9}},
                                      {{0xEE, 0xF3, 0xF2}, {0xDC, 0xE6, 0xE4}},
                                      {{0xD6, 0xCB, 0xD8}, {0xE9, 0xCF, 0xC3}}};
  static const QColor kTables[3] = {{0xCF, 0xB0, 0x8A}, {0xC8, 0xA8, 0x80}, {0xA3, 0x7E, 0x64}};
  const auto hour = static_cast<std::size_t>(light);
  QLinearGradient wall(area.topLeft(), area.bottomLeft());
  wall.setColorAt(0.0, kWalls[hour][0]);
  wall.setColorAt(1.0, kWalls[hour][1]);
  painter.fillRect(area, wall);
  QRectF table = area;
  table.setTop(area.bottom() - 0.07 * area.height());
  QLinearGradient top(table.topLeft(), table.bottomLeft());
  top.setColorAt(0.0, kTables[hour].darker(112));
  top.setColorAt(1.0, kTables[hour]);
  painter.fillRect(table, top);
}

void paint_crate(QPainter& painter, const QRectF& box, bool held, bool on_target) {
  const double w = box.width(), h = box.height();
  const double apple = 0.105 * w;
  for (int k = 0; k < 5; ++k)
    paint_apple(painter,
                {box.left() + (0.14 + 0.18 * k) * w, box.top() + (k % 2 == 0 ? 0.03 : 0.0) * h},
                apple, k != 1 && k != 4);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x5C, 0x3A, 0x1E));
  painter.drawRect(QRectF(box.left(), box.top() + 0.04 * h, w, 0.96 * h));
  painter.setPen(QPen(kContour, std::max(1.0, 0.008 * w)));
  constexpr int kBoards = 4;
  for (int k = 0; k < kBoards; ++k) {
    const QRectF board(box.left(), box.top() + (0.04 + 0.245 * k) * h, w, 0.215 * h);
    painter.setBrush(wood(board));
    painter.drawRoundedRect(board, 0.015 * w, 0.015 * w);
  }
  for (const double at : {0.04, 0.86}) {
    const QRectF post(box.left() + at * w, box.top(), 0.10 * w, h);
    painter.setBrush(wood(post));
    painter.drawRect(post);
    painter.setBrush(kContour);
    for (const double y : {0.14, 0.39, 0.64, 0.88})
      painter.drawEllipse(QPointF(post.center().x(), box.top() + y * h), 0.010 * w, 0.010 * w);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(on_target ? kReached : kContour,
                      on_target ? 9
                      : held    ? 7
                                : 3,
                      Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(box);
}

void paint_tea_tray(QPainter& painter, const QRectF& board, bool on_target) {
  const double thick = board.height();
  const double middle = board.center().x();
  paint_cup(painter, middle - 4.6 * thick, board.top(), 1.25 * thick);
  paint_pot(painter, middle, board.top(), 1.9 * thick);
  paint_cup(painter, middle + 3.3 * thick, board.top(), 1.25 * thick);
  QPainterPath tray(board.topLeft() + QPointF(-0.25 * thick, -0.35 * thick));
  tray.lineTo(board.topLeft() + QPointF(0.35 * thick, 0.0));
  tray.lineTo(board.topRight() + QPointF(-0.35 * thick, 0.0));
  tray.lineTo(board.topRight() + QPointF(0.25 * thick, -0.35 * thick));
  tray.lineTo(board.bottomRight());
  tray.lineTo(board.bottomLeft());
  tray.closeSubpath();
  painter.setPen(QPen(on_target ? kReached : kContour, on_target ? 6 : 3));
  painter.setBrush(on_target ? QBrush(kReached.lighter(150)) : QBrush(wood(board)));
  painter.drawPath(tray);
  painter.setPen(QPen(on_target ? kReached : kWoodDark, 0.06 * thick));
  painter.drawLine(QPointF(board.left() + 0.4 * thick, board.center().y()),
                   QPointF(board.right() - 0.4 * thick, board.center().y()));
}

}  // namespace isograsp::gui
