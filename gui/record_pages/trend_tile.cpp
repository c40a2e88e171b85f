// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/trend_tile.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "gui/look/look.hpp"

namespace isograsp::gui {

namespace {
constexpr int kTileEdge_px = 10;
constexpr int kPlot_px = 96;
constexpr int kTileText_px = 60;  // title, task and remark: three lines

/// As much of a text as has room. What distinguishes it from others comes after its last separator:
/// the finger in "Maximum force above rest, thumb", the hand in "Maximum force · right hand", and
/// is kept.
QString shortened(const QString& text, const QString& separator, const QFontMetrics& metrics,
                  int width_px) {
  const int last = text.lastIndexOf(separator);
  if (last < 0 || metrics.horizontalAdvance(text) <= width_px)
    return metrics.elidedText(text, Qt::ElideRight, width_px);
  const QString kept = text.mid(last);
  const int room_px = width_px - metrics.horizontalAdvance(kept);
  constexpr int kLeastLetters = 4;  // of the rest
  if (room_px < kLeastLetters * metrics.averageCharWidth()) {
    const QString alone = text.mid(last + separator.size());
    const QString with_mark = QStringLiteral("… ") + alone;
    return metrics.horizontalAdvance(with_mark) <= width_px
               ? with_mark
               : metrics.elidedText(alone, Qt::ElideMiddle, width_px);
  }
  return metrics.elidedText(text.left(last), Qt::ElideRight, room_px) + kept;
}
}  // namespace

TrendTile::TrendTile(const MeasureTrend& trend, QWidget* parent)
    : QWidget(parent), title_(trend.title), task_(trend.task), last_(trend.last) {
  setFocusPolicy(Qt::ClickFocus);
  setCursor(Qt::PointingHandCursor);
  setMinimumSize(scaled(210), scaled(kTileText_px + kPlot_px) + 10);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(5, scaled(kTileText_px), 6, 4);
  auto* plot = new SessionTrendPlot(SessionTrendPlot::Size::small);
  plot->setMinimumHeight(scaled(kPlot_px));
  plot->setAttribute(Qt::WA_TransparentForMouseEvents);
  plot->show_trend(trend);
  column->addWidget(plot);
  set_remark(trend.remark);
}

void TrendTile::set_remark(const QString& remark) {
  remark_ = remark;
  const QString below = remark_.isEmpty() ? QString() : tr("\n%1").arg(remark_);
  describe(
      *this, tr("%1, %2: %3").arg(title_, task_, last_) + below,
      tr("%1\n%2\nNewest value %3.%4 Arrow keys go to the next picture, Enter or a click shows "
         "this one large (F4)")
          .arg(title_, task_, last_, below.isEmpty() ? below : below + QStringLiteral(".\n")));
  update();
}

void TrendTile::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(hasFocus() ? look::kAccent : look::kLine, hasFocus() ? 2.0 : 1.0));
  painter.setBrush(look::kCard);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 8, 8);
  QFont bold = font();
  bold.setBold(true);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() - 1.0);
  QRect line(kTileEdge_px, 8, width() - 2 * kTileEdge_px, QFontMetrics(bold).height());
  painter.setFont(bold);
  painter.setPen(look::kText);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, last_);
  const int value_px = QFontMetrics(bold).horizontalAdvance(last_) + 10;
  painter.drawText(
      line, Qt::AlignLeft | Qt::AlignVCenter,
      shortened(title_, QStringLiteral(", "), QFontMetrics(bold), line.width() - value_px));
  painter.setFont(small);
  const QFontMetrics metrics(small);
  const auto say = [&](const QString& text, const QColor& colour) {
    line.moveTop(line.bottom() + 2);
    line.setHeight(metrics.height());
    painter.setPen(colour);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text);
  };
  say(shortened(task_, QStringLiteral(" · "), metrics, line.width()), look::kQuietText);
  say(metrics.elidedText(remark_, Qt::ElideRight, line.width()), look::kText);
}

void TrendTile::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && rect().contains(event->pos())) Q_EMIT opened();
}

void TrendTile::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ||
      event->key() == Qt::Key_Space)
    Q_EMIT opened();
  else
    event->ignore();
}

void TrendTile::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void TrendTile::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace isograsp::gui
