// SPDX-License-Identifier: GPL-3.0-or-later
// The frame that all plots of a report share: fonts, axes, margins, the key above.
#include <cmath>

#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

namespace {
constexpr double kFont = 6.8;  // points
}

QFont report_font(double pixels, bool bold) {
  QFont font("DejaVu Sans");
  font.setPixelSize(static_cast<int>(std::lround(pixels)));
  font.setBold(bold);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

PlotView::PlotView(QSizeF size, double unit)
    : size_(size), unit_(unit), plot_(std::make_unique<QCustomPlot>()) {
  plot_->setBackground(Qt::NoBrush);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(0);
  plot_->plotLayout()->setColumnSpacing(0);
}
PlotView::~PlotView() = default;
PlotView::PlotView(PlotView&&) noexcept = default;
PlotView& PlotView::operator=(PlotView&&) noexcept = default;

QCPAxisRect& PlotView::add_axes(QRectF inner) {
  auto* rect = new QCPAxisRect(plot_.get(), false);  // the layout owns it
  plot_->plotLayout()->addElement(plot_->plotLayout()->rowCount(), 0, rect);
  const int row = plot_->plotLayout()->rowCount() - 1;
  const auto whole = [this](double points) { return static_cast<int>(std::lround(px(points))); };
  const double above = row == 0 ? 0.0 : bottom_;
  rect->setAutoMargins(QCP::msNone);
  rect->setMargins(
      {whole(inner.left()), whole(inner.top() - above), whole(size_.width() - inner.right()), 0});
  const QSize exact(whole(inner.width()), whole(inner.height()));
  rect->setMinimumSize(exact);
  rect->setMaximumSize(exact);
  bottom_ = inner.bottom();
  for (const auto side : {QCPAxis::atBottom, QCPAxis::atLeft}) {
    QCPAxis* axis = rect->addAxis(side);
    axis->setLayer("axes");
    axis->grid()->setLayer("grid");
    axis->grid()->setVisible(true);
    axis->setBasePen(
        QPen(side == QCPAxis::atBottom ? Palette::quiet() : QColor(0, 0, 0, 0), px(0.5)));
    axis->setTickPen(QPen(Palette::quiet(), px(0.5)));
    axis->setSubTicks(false);
    axis->setTickLength(0, side == QCPAxis::atBottom ? whole(2.5) : 0);
    axis->setTickLabelFont(report_font(px(kFont), false));
    axis->setTickLabelColor(Palette::quiet());
    axis->setTickLabelPadding(whole(side == QCPAxis::atBottom ? 2 : 4));
    axis->setLabelFont(report_font(px(kFont), false));
    axis->setLabelColor(Palette::quiet());
    axis->setLabelPadding(whole(3));
    axis->setNumberFormat("g");
    axis->setNumberPrecision(6);  // whole numbers: never 1.2e+04
    axis->ticker()->setTickCount(4);
    axis->grid()->setPen(side == QCPAxis::atBottom ? QPen(Qt::NoPen)
                                                   : QPen(Palette::line(), px(0.5)));
    axis->grid()->setZeroLinePen(QPen(Qt::NoPen));
  }
  return *rect;
}

void PlotView::explain(Mark mark, const QColor& color, const QString& text) {
  keys_.push_back({mark, color, text});
}

void PlotView::paint(QCPPainter& painter) {
  painter.save();
  painter.setMode(QCPPainter::pmVectorized);
  plot_->toPainter(&painter, static_cast<int>(std::lround(px(size_.width()))),
                   static_cast<int>(std::lround(px(size_.height()))));
  painter.restore();
  painter.save();
  const QFont font = report_font(px(kFont), false);
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  double x = px(key_left_);
  const double y = px(4.5);
  for (const Key& key : keys_) {
    const double width = px(key.mark >= Mark::ring ? 5 : 13);
    QPen pen(key.color, px(key.mark == Mark::dotted ? 0.8 : 1.2));
    painter.setBrush(Qt::NoBrush);
    if (key.mark == Mark::dashed) pen.setDashPattern({3.5, 2.0});
    if (key.mark == Mark::dotted) pen.setDashPattern({1.5, 2.0});
    if (key.mark == Mark::band) {
      painter.fillRect(QRectF(x, y - px(2.5), width, px(5)), key.color);
    } else if (key.mark >= Mark::ring) {
      const QRectF box(x, y - px(2.5), px(5), px(5));
      painter.setPen(QPen(key.color, px(1)));
      painter.setBrush(key.mark == Mark::ring ? QBrush(Qt::white) : QBrush(key.color));
      if (key.mark == Mark::square)
        painter.drawRect(box);
      else
        painter.drawEllipse(box);
    } else {
      painter.setPen(pen);
      painter.drawLine(QLineF(x, y, x + width, y));
    }
    x += width + px(3);
    painter.setPen(Palette::quiet());
    painter.drawText(QPointF(x, y + px(kFont) * 0.36), key.text);
    x += metrics.horizontalAdvance(key.text) + px(9);
  }
  painter.restore();
}

}  // namespace isograsp::reports
