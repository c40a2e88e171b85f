// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/sparkline.hpp"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <utility>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr double kDot_px = 3.5;  // radius
constexpr double kSparkLine_px = 2.0;
}  // namespace

Sparkline::Sparkline(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void Sparkline::show_values(std::vector<double> values) {
  values_ = std::move(values);
  update();
}

void Sparkline::paintEvent(QPaintEvent*) {
  if (values_.empty()) return;
  const auto [least, most] = std::minmax_element(values_.begin(), values_.end());
  const double range = *most - *least;
  const QRectF room = QRectF(rect()).adjusted(kDot_px, kDot_px + 1, -kDot_px - 1, -kDot_px - 1);
  const auto point = [&](std::size_t i) {
    const double along =
        values_.size() > 1 ? static_cast<double>(i) / static_cast<double>(values_.size() - 1) : 1.0;
    const double up = range > 0.0 ? (values_[i] - *least) / range : 0.5;
    return QPointF(room.left() + along * room.width(), room.bottom() - up * room.height());
  };
  QPainterPath line(point(0));
  for (std::size_t i = 1; i < values_.size(); ++i) line.lineTo(point(i));
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(look::kAccent, kSparkLine_px, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(line);
  painter.setPen(Qt::NoPen);
  painter.setBrush(look::kAccent);
  painter.drawEllipse(point(values_.size() - 1), kDot_px, kDot_px);
}

}  // namespace isograsp::gui
