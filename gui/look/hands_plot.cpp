// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/look/hands_plot.hpp"

#include <algorithm>

#include "gui/look/look.hpp"
#include "gui/look/plot_style.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::gui {

HandsPlot::HandsPlot(QWidget* parent) : QWidget(parent), plot_(make_plot(*this)) {
  constexpr double kRoomForLabels_s = 2.4;
  plot_->xAxis->setRange(-20.0, kRoomForLabels_s);
  plot_->xAxis->setLabel(tr("Time before now (s)"));
  plot_->yAxis->setLabel(tr("Grip force (N)"));
  plot_->yAxis->setRange(-0.5, 5.0);
  plot_->yAxis->ticker()->setTickCount(5);
  const std::array<QColor, kCurves> colours{look::kFingers[0], look::kFingers[1], look::kText};
  const std::array<QString, kCurves> letters{tr("L", "left hand, at the end of its curve"),
                                             tr("R", "right hand, at the end of its curve"),
                                             tr("L+R", "both hands, at the end of their curve")};
  for (std::size_t k = 0; k < kCurves; ++k) {
    targets_[k] = plot_->addGraph();
    targets_[k]->setPen(QPen(colours[k], 1, Qt::DashLine));
    forces_[k] = plot_->addGraph();
    forces_[k]->setPen(QPen(colours[k], 1));
    labels_[k] = new QCPItemText(plot_);
    labels_[k]->setText(letters[k]);
    labels_[k]->setColor(colours[k]);
    QFont bold = font();
    bold.setBold(true);
    labels_[k]->setFont(bold);
    labels_[k]->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    labels_[k]->position->setTypeX(QCPItemPosition::ptPlotCoords);
    labels_[k]->position->setTypeY(QCPItemPosition::ptPlotCoords);
    labels_[k]->setVisible(false);
  }
}

void HandsPlot::show_forces(const HandsHistory& history) {
  const auto& points = history.points();
  std::array<QVector<QCPGraphData>, kCurves> forces;
  std::array<QVector<QCPGraphData>, kCurves> targets;
  for (const HandsPoint& point : points) {
    const double t_s = point.t_s - points.back().t_s;
    const std::array<double, kCurves> force_N{point.force_N.left, point.force_N.right,
                                              point.sum_N()};
    const std::array<double, kCurves> target_N{point.target_N.left, point.target_N.right,
                                               point.target_sum_N};
    for (std::size_t k = 0; k < kCurves; ++k) {
      forces[k].append(QCPGraphData(t_s, force_N[k]));
      targets[k].append(QCPGraphData(t_s, target_N[k]));
    }
  }
  for (std::size_t k = 0; k < kCurves; ++k) {
    forces_[k]->data()->set(forces[k], true);
    targets_[k]->data()->set(targets[k], true);
    labels_[k]->setVisible(!points.empty());
  }
  const auto range = history.range();
  plot_->yAxis->setRange(range.least_N, range.most_N);
  if (!points.empty()) {
    constexpr double kHeight_px = 13.0;
    const double pixels = std::max(1, plot_->yAxis->axisRect()->height());
    const double apart_N = kHeight_px * plot_->yAxis->range().size() / pixels;
    const HandsPoint& last = points.back();
    const auto place = label_places({last.force_N.left, last.force_N.right, last.sum_N()}, apart_N,
                                    plot_->yAxis->range().lower);
    for (std::size_t k = 0; k < kCurves; ++k) labels_[k]->position->setCoords(0.3, place[k]);
  }
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace isograsp::gui
