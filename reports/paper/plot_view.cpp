// SPDX-License-Identifier: GPL-3.0-or-later
// The frame that all plots of a report share: fonts, axes, margins, the key above.
#include <algorithm>
#include <cmath>

#include "reports/paper/plots.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::reports {

namespace {
constexpr double kFont = 6.8;  // points
constexpr double kLeastFont = 5.0;
constexpr double kKeyGap = 9.0;  ///< between one word of the key and the next

/// Numbers at the axes are as those in the text, whatever the language of the desktop.
QLocale locale_of(const Language& language) {
  const auto code = language_code(language);
  if (code == language_code(kEnglish)) return QLocale::c();
  QLocale locale(QString::fromStdString(code));
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale;
}

}  // namespace

QFont report_font(double pixels, bool bold) {
  QFont font("DejaVu Sans");
  font.setPixelSize(static_cast<int>(std::lround(pixels)));
  font.setBold(bold);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

PlotView::PlotView(QSizeF size, double unit, const Language& language)
    : size_(size), unit_(unit), say_(language), plot_(std::make_unique<QCustomPlot>()) {
  plot_->setLocale(locale_of(language));
  plot_->setBackground(Qt::NoBrush);
  plot_->plotLayout()->clear();
  plot_->plotLayout()->setRowSpacing(0);
  plot_->plotLayout()->setColumnSpacing(0);
}
PlotView::~PlotView() = default;
PlotView::PlotView(PlotView&&) noexcept = default;

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

QString PlotView::said(const Text& text) const {
  return QString::fromStdString(say_(text));
}
QString PlotView::said(const Number& number) const {
  return QString::fromStdString(say_(number));
}

void PlotView::explain(Mark mark, const QColor& color, const Text& text) {
  keys_.push_back({mark, color, said(text)});
}

void PlotView::paint(QCPPainter& painter) {
  painter.save();
  painter.setMode(QCPPainter::pmVectorized);
  plot_->toPainter(&painter, static_cast<int>(std::lround(px(size_.width()))),
                   static_cast<int>(std::lround(px(size_.height()))));
  painter.restore();
  painter.save();
  const auto mark_width = [this](const Key& key) { return px(key.mark >= Mark::ring ? 5 : 13); };
  const auto length = [&](const QFont& font) {
    double sum = -px(kKeyGap);
    for (const Key& key : keys_)
      sum += mark_width(key) + px(3 + kKeyGap) + QFontMetricsF(font).horizontalAdvance(key.text);
    return sum;
  };
  // Words that are too long for the room above the axes begin farther left, then they are smaller.
  QFont font = report_font(px(kFont), false);
  for (double size = kFont; size > kLeastFont && length(font) > px(size_.width()); size -= 0.2)
    font = report_font(px(size), false);
  const QFontMetricsF metrics(font);
  painter.setFont(font);
  double x = std::clamp(px(size_.width()) - length(font), 0.0, px(key_left_));
  const double y = px(4.5);
  for (const Key& key : keys_) {
    const double width = mark_width(key);
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
    x += metrics.horizontalAdvance(key.text) + px(kKeyGap);
  }
  painter.restore();
}

}  // namespace isograsp::reports
