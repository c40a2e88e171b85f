// SPDX-License-Identifier: GPL-3.0-or-later
// A combo box whose arrow goes with the style sheet: styled boxes lose the one of the platform.
#pragma once

#include <QComboBox>
#include <QPainter>

#include "gui/look/look.hpp"

namespace isograsp::gui {

class ChoiceBox final : public QComboBox {
  Q_OBJECT

 public:
  using QComboBox::QComboBox;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QComboBox::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double larger = scaled(100) / 100.0;
    painter.translate(width() - 15.0 * larger, height() / 2.0);
    painter.scale(larger, larger);
    painter.setPen(QPen(isEnabled() ? look::kText : look::kLine, 1.6, Qt::SolidLine, Qt::RoundCap,
                        Qt::RoundJoin));
    painter.drawPolyline(polygon({{-4.5, -2.0}, {0.0, 2.5}, {4.5, -2.0}}));
  }
};

}  // namespace isograsp::gui
