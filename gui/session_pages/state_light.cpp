// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/session_pages/state_light.hpp"

#include <QPainter>
#include <QPainterPath>

#include "gui/look/look.hpp"

namespace isograsp::gui {

StateLight::StateLight(int size_px, QWidget* parent) : QWidget(parent) {
  setFixedSize(scaled(size_px), scaled(size_px));
  show_mood(Mood::off);
}

void StateLight::show_mood(Mood mood) {
  mood_ = mood;
  const auto word = QString::fromStdString(word_for(mood));
  setAccessibleName(tr("State: %1").arg(word));
  setToolTip(word);
  update();
}

void StateLight::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const qreal unit = width() / 24.0;  // the drawings below are on a 24 x 24 grid
  painter.scale(unit, unit);
  const auto stroke = [&](const QColor& colour, qreal pen_width) {
    painter.setPen(QPen(colour, pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
  };
  const auto fill = [&](const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
  };
  switch (mood_) {
    case Mood::off:
      stroke(look::kQuietText, 2.0);
      painter.drawEllipse(QPointF(12, 12), 8.5, 8.5);
      break;
    case Mood::busy:
      fill(look::kAccent);
      for (const qreal x : {5.0, 12.0, 19.0}) painter.drawEllipse(QPointF(x, 12), 2.7, 2.7);
      break;
    case Mood::ready: {
      fill(look::kReady);
      painter.drawEllipse(QPointF(12, 12), 10.5, 10.5);
      stroke(Qt::white, 2.6);
      painter.drawPolyline(polygon({{7.2, 12.4}, {10.6, 15.8}, {17.0, 8.8}}));
      break;
    }
    case Mood::turn: {
      fill(look::kAccent);
      painter.drawEllipse(QPointF(12, 12), 10.5, 10.5);
      stroke(Qt::white, 2.6);
      painter.drawPolyline(polygon({{9.8, 7.2}, {14.6, 12.0}, {9.8, 16.8}}));
      break;
    }
    case Mood::attention: {
      fill(look::kAttention);
      QPainterPath triangle;
      triangle.addPolygon(polygon({{12, 1.8}, {23, 21.5}, {1, 21.5}}));
      triangle.closeSubpath();
      painter.setPen(QPen(look::kAttention, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter.drawPath(triangle);
      stroke(look::kText, 2.4);
      painter.drawLine(QPointF(12, 9), QPointF(12, 14.5));
      painter.drawPoint(QPointF(12, 18.2));
      break;
    }
    case Mood::fault:
      fill(look::kFault);
      painter.drawRoundedRect(QRectF(2, 2, 20, 20), 4, 4);
      stroke(Qt::white, 2.6);
      painter.drawLine(QPointF(8, 8), QPointF(16, 16));
      painter.drawLine(QPointF(16, 8), QPointF(8, 16));
      break;
  }
}

}  // namespace isograsp::gui
