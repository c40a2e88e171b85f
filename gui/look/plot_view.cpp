// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/plot_view.hpp"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/look/plot_style.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::gui {

QCustomPlot* make_plot(QWidget& parent) {
  auto* plot = new QCustomPlot(&parent);
  auto* layout = new QVBoxLayout(&parent);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot);
  plot->setFocusPolicy(Qt::NoFocus);
  plot->setAttribute(Qt::WA_TransparentForMouseEvents);  // the tooltip is that of the view
  plot->setBackground(look::kCard);
  for (auto* axis : {plot->xAxis, plot->yAxis}) {
    axis->setBasePen(QPen(look::kLine));
    axis->setTickPen(QPen(look::kLine));
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(look::kQuietText);
    axis->setLabelColor(look::kQuietText);
    axis->grid()->setPen(QPen(look::kGrid));
    axis->grid()->setZeroLinePen(QPen(look::kEdge));
    axis->ticker()->setTickStepStrategy(QCPAxisTicker::tssReadability);
  }
  return plot;
}

LivePlot::LivePlot(QWidget* parent) : QWidget(parent), plot_(make_plot(*this)) {
  constexpr double kRoomForLabels_s = 1.6;
  plot_->xAxis->setRange(-20.0, kRoomForLabels_s);
  plot_->xAxis->setLabel(tr("Time before now (s)"));
  plot_->yAxis->setLabel(tr("Normal force (N)"));
  plot_->yAxis->setRange(-0.5, 5.0);
  plot_->yAxis->ticker()->setTickCount(5);
  target_ = plot_->addGraph();
  target_->setPen(QPen(look::kText, 1, Qt::DashLine));
  for (const Finger finger : kFingers) {
    const auto f = index_of(finger);
    fingers_[f] = plot_->addGraph();
    fingers_[f]->setPen(QPen(look::kFingers[f], 1));
    labels_[f] = new QCPItemText(plot_);
    labels_[f]->setText(finger_title(finger).left(1));
    labels_[f]->setColor(look::kFingers[f]);
    QFont bold = font();
    bold.setBold(true);
    labels_[f]->setFont(bold);
    labels_[f]->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    labels_[f]->position->setTypeX(QCPItemPosition::ptPlotCoords);
    labels_[f]->position->setTypeY(QCPItemPosition::ptPlotCoords);
    labels_[f]->setVisible(false);
  }
}

void LivePlot::show_forces(const ForceHistory& history) {
  const auto& points = history.points();
  std::array<QVector<QCPGraphData>, kFingerCount> curves;
  QVector<QCPGraphData> target;
  const auto count = static_cast<int>(points.size());
  for (auto& curve : curves) curve.reserve(count);
  target.reserve(count);
  for (const auto& point : points) {
    const double t_s = point.t_s - points.back().t_s;
    for (std::size_t f = 0; f < kFingerCount; ++f)
      curves[f].append(QCPGraphData(t_s, point.normal_N[f]));
    target.append(QCPGraphData(t_s, point.target_N));
  }
  for (std::size_t f = 0; f < kFingerCount; ++f) fingers_[f]->data()->set(curves[f], true);
  target_->data()->set(target, true);
  const auto range = history.range();
  plot_->yAxis->setRange(range.least_N, range.most_N);
  for (auto* label : labels_) label->setVisible(!points.empty());
  if (!points.empty()) place_labels(points.back());
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void LivePlot::place_labels(const ForcePoint& last) {
  constexpr double kHeight_px = 13.0;
  const double pixels = std::max(1, plot_->yAxis->axisRect()->height());
  const double apart_N = kHeight_px * plot_->yAxis->range().size() / pixels;
  const auto place = label_places(last.normal_N, apart_N, plot_->yAxis->range().lower);
  for (std::size_t f = 0; f < kFingerCount; ++f) labels_[f]->position->setCoords(0.3, place[f]);
}

TrendPlot::TrendPlot(QWidget* parent) : QWidget(parent), plot_(make_plot(*this)) {
  line_ = plot_->addGraph();
  line_->setPen(QPen(look::kLine, 1));
  const auto dots = [&](const QColor& fill) {
    auto* graph = plot_->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(look::kAccent, 1.5), fill, 8));
    return graph;
  };
  practised_ = dots(Qt::white);
  assessed_ = dots(look::kAccent);
  plot_->xAxis->setLabel(tr("Trial"));
  auto ticker = QSharedPointer<QCPAxisTickerFixed>::create();
  ticker->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  plot_->xAxis->setTicker(ticker);
  plot_->yAxis->ticker()->setTickCount(4);
}

void TrendPlot::show_trend(const std::vector<TrendPoint>& points, const QString& axis) {
  QVector<double> all_x, all_y, done_x, done_y, tried_x, tried_y;
  double least = 0.0;
  double most = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = static_cast<double>(i + 1);
    const double y = points[i].value;
    all_x.append(x);
    all_y.append(y);
    (points[i].practice ? tried_x : done_x).append(x);
    (points[i].practice ? tried_y : done_y).append(y);
    least = std::min(least, y);
    most = std::max(most, y);
  }
  line_->setData(all_x, all_y, true);
  assessed_->setData(done_x, done_y, true);
  practised_->setData(tried_x, tried_y, true);
  const double room = most > least ? 0.12 * (most - least) : 1.0;
  plot_->xAxis->setRange(0.5, std::max(5.5, static_cast<double>(points.size()) + 0.5));
  plot_->yAxis->setRange(least < 0.0 ? least - room : 0.0, most > 0.0 ? most + room : room);
  plot_->yAxis->setLabel(axis);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace isograsp::gui
