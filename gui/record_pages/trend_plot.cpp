// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/record_pages/trend_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/look/plot_style.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::gui {

namespace {
/// Trials of one session stand side by side, together at most this wide [sessions].
constexpr double kSessionWidth = 0.5;
constexpr double kTrialWidth = 0.12;

/// Where each point stands along the axis: trials of a session around its number, in their order.
std::vector<double> places(const std::vector<MeasureTrend::Point>& points) {
  std::vector<double> places(points.size());
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin;
    while (end < points.size() && points[end].session == points[begin].session) ++end;
    const auto count = static_cast<double>(end - begin);
    const double step = count < 2 ? 0.0 : std::min(kTrialWidth, kSessionWidth / (count - 1.0));
    for (std::size_t i = begin; i < end; ++i)
      places[i] = points[i].session + step * (static_cast<double>(i - begin) - (count - 1.0) / 2.0);
    begin = end;
  }
  return places;
}
}  // namespace

SessionTrendPlot::SessionTrendPlot(Size size, QWidget* parent)
    : QWidget(parent), size_(size), plot_(make_plot(*this)) {
  const bool large = size == Size::large;
  means_ = plot_->addGraph();
  means_->setPen(QPen(look::kPaleAccent, large ? 2.0 : 1.5));
  const auto marks = [&](QCPScatterStyle::ScatterShape shape, const QColor& fill, double grow) {
    auto* graph = plot_->addGraph();
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setScatterStyle(QCPScatterStyle(shape, QPen(look::kAccent, large ? 1.5 : 1.2), fill,
                                           grow * (large ? 8.0 : 5.5)));
    return graph;
  };
  practised_ = marks(QCPScatterStyle::ssCircle, Qt::white, 1.0);
  helped_ = marks(QCPScatterStyle::ssTriangle, Qt::white, 1.25);
  assessed_ = marks(QCPScatterStyle::ssDisc, look::kAccent, 1.0);
  assessed_->setName(tr("assessment"));
  practised_->setName(tr("practice"));
  helped_->setName(tr("helped"));
  means_->setName(tr("mean of a session's assessments"));
  plot_->yAxis->ticker()->setTickCount(large ? 6 : 3);
  plot_->xAxis->setLabel(large ? tr("Session") : QString());
  if (large) {
    plot_->legend->setVisible(true);
    plot_->legend->setBorderPen(Qt::NoPen);
    plot_->legend->setBrush(Qt::NoBrush);
    plot_->legend->setTextColor(look::kQuietText);
    if (side_by_side() != QBoxLayout::LeftToRight) plot_->legend->setWrap(2);
    plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot_->plotLayout()->insertRow(0);
    plot_->plotLayout()->addElement(0, 0, plot_->legend);
    plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  } else {
    QFont small = font();
    small.setPointSizeF(small.pointSizeF() - 1.5);
    for (auto* axis : {plot_->xAxis, plot_->yAxis}) {
      axis->setTickLabelFont(small);
      axis->setTickLabelPadding(2);
      axis->setPadding(0);
      axis->setTickLength(0, 3);
    }
  }
}

void SessionTrendPlot::show_trend(const MeasureTrend& trend) {
  std::array<QVector<double>, 3> x;
  std::array<QVector<double>, 3> y;
  const auto where = places(trend.points);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t i = 0; i < trend.points.size(); ++i) {
    const auto kind = static_cast<std::size_t>(trend.points[i].kind);
    x[kind].append(where[i]);
    y[kind].append(trend.points[i].value);
    least = std::min(least, trend.points[i].value);
    most = std::max(most, trend.points[i].value);
  }
  assessed_->setData(x[0], y[0], true);
  practised_->setData(x[1], y[1], true);
  helped_->setData(x[2], y[2], true);
  QVector<double> mean_x, mean_y;
  for (const auto& mean : trend.means) {
    mean_x.append(mean.session);
    mean_y.append(mean.value);
  }
  means_->setData(mean_x, mean_y, true);
  if (size_ == Size::large) {
    plot_->legend->clearItems();
    if (!mean_x.isEmpty()) means_->addToLegend();
    for (auto* marks : {assessed_, practised_, helped_})
      if (marks->dataCount() > 0) marks->addToLegend();
  }
  if (trend.points.empty()) return;
  const int first = trend.points.front().session;
  const int last = trend.points.back().session;
  // From zero where nothing is negative: a trend must not look steeper than it is.
  least = std::min(0.0, least);
  most = std::max(0.0, most);
  const double room = most > least ? 0.12 * (most - least) : 1.0;
  plot_->yAxis->setRange(least < 0.0 ? least - room : 0.0, most + room);
  plot_->xAxis->setRange(first - 0.6, std::max(last, first + 3) + 0.6);
  const bool large = size_ == Size::large;
  if (large) plot_->yAxis->setLabel(trend.unit);
  auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const std::size_t most_labels = large ? 7 : 6;  // of dates and of numbers
  const auto every = static_cast<int>((trend.dates.size() + most_labels - 1) / most_labels);
  int number = 0;
  for (const auto& [session, date] : trend.dates)
    if (number++ % std::max(1, every) == 0)
      ticker->addTick(session,
                      large ? tr("%1\n%2").arg(session).arg(date) : QString::number(session));
  plot_->xAxis->setTicker(ticker);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace isograsp::gui
