// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/trial_pages/trial_plot.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "gui/look/look.hpp"
#include "gui/look/plot_style.hpp"
#include "hand/columns.hpp"
#include "reports/paper/plotting.hpp"

namespace isograsp::gui {

namespace {

constexpr double kNoCurve = std::numeric_limits<double>::quiet_NaN();
/// More marks or shaded stretches than this would hide the curves.
constexpr int kMostItems = 200;
constexpr double kShortest_s = 0.2;  ///< least stretch of time on the screen
const QColor kNotScored{0xF0, 0xF2, 0xF5};

/// Runs of rows of which `asked` is true, as [first, behind the last).
template <class Asked>
std::vector<std::pair<std::size_t, std::size_t>> runs(std::size_t rows, Asked asked) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t row = 0; row < rows; ++row) {
    if (!asked(row)) continue;
    if (!found.empty() && found.back().second == row)
      ++found.back().second;
    else
      found.emplace_back(row, row + 1);
  }
  return found;
}

}  // namespace

QString mark_letter(const std::string& kind) {
  if (kind == "fault") return QObject::tr("F");
  if (kind == "pause") return QObject::tr("P");
  if (kind == "resume") return QObject::tr("R");
  if (kind == "note") return QObject::tr("N");
  if (kind == "abort") return QObject::tr("A");
  return QStringLiteral("•");
}

QString mark_words(const std::string& kind) {
  if (kind == "fault") return QObject::tr("Fault");
  if (kind == "pause") return QObject::tr("Pause");
  if (kind == "resume") return QObject::tr("Resumed");
  if (kind == "note") return QObject::tr("Note");
  if (kind == "abort") return QObject::tr("Aborted");
  return QString::fromStdString(kind);
}

TrialPlot::TrialPlot(QWidget* parent) : QWidget(parent), plot_(make_plot(*this)) {
  setFocusPolicy(Qt::StrongFocus);
  layout()->setContentsMargins(2, 2, 2, 2);  // room for the frame of the focus
  plot_->xAxis->setLabel(tr("Time (s)"));
  plot_->yAxis->ticker()->setTickCount(5);
  plot_->yAxis2->setRange(0.0, 1.0);  // of the bar where samples are missing
  // The cursor moves alone: the curves are not drawn again with it.
  plot_->addLayer("cursor");
  plot_->layer("cursor")->setMode(QCPLayer::lmBuffered);
  cursor_ = new QCPItemStraightLine(plot_);
  cursor_->setLayer("cursor");
  cursor_->setPen(QPen(look::kAccent, 1.5));
}

void TrialPlot::add_curve(const TrialReplay& replay, const TrialCurve& curve) {
  if (!curve.column) return;
  const auto t_s = replay.signals().column(columns::t_s);
  const auto values = replay.signals().column(*curve.column);
  QVector<QCPGraphData> measured;
  QVector<QCPGraphData> held;
  measured.reserve(static_cast<int>(values.size()) + 16);
  bool was_held = false;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const auto quality = quality_of(replay, curve, row);
    const double value = curve.factor * values[row];
    measured.append(QCPGraphData(t_s[row], quality == SampleQuality::measured ? value : kNoCurve));
    if (quality == SampleQuality::held) {
      const double until_s = row + 1 < values.size() ? t_s[row + 1] : t_s[row];
      if (!was_held) held.append({t_s[row], kNoCurve});
      held.append({t_s[row], value});
      held.append({until_s, value});
    }
    was_held = quality == SampleQuality::held;
    if (replay.gap_after(row)) measured.append({t_s[row] + replay.period_s(), kNoCurve});
  }
  auto* graph = plot_->addGraph();
  graph->setPen(QPen(curve.colour, 1, curve.target ? Qt::DashLine : Qt::SolidLine));
  graph->data()->set(measured, true);
  if (held.isEmpty()) return;
  auto* dotted = plot_->addGraph();
  dotted->setPen(QPen(curve.colour, 1, Qt::DotLine));
  dotted->data()->set(held, true);
}

void TrialPlot::add_missing(const TrialReplay& replay, const std::vector<TrialCurve>& curves) {
  const auto t_s = replay.signals().column(columns::t_s);
  const bool looked_at = std::any_of(curves.begin(), curves.end(), [](const TrialCurve& curve) {
    return curve.finger || curve.of_hand;
  });
  QVector<QCPGraphData> missing;
  const auto add = [&](double from_s, double to_s) {
    constexpr double kJustAboveAxis = 0.012;
    missing.append({from_s, kJustAboveAxis});
    missing.append({to_s, kJustAboveAxis});
    missing.append({to_s, kNoCurve});
  };
  for (const auto& [first, behind] : runs(replay.rows(), [&](std::size_t row) {
         return looked_at && replay.quality(row) == SampleQuality::missing;
       }))
    add(t_s[first], behind < t_s.size() ? t_s[behind] : t_s[behind - 1] + replay.period_s());
  for (std::size_t row = 0; row < replay.rows(); ++row)
    if (replay.gap_after(row)) add(t_s[row] + replay.period_s(), t_s[row + 1]);
  if (missing.isEmpty()) return;
  auto* bar = plot_->addGraph(plot_->xAxis, plot_->yAxis2);
  bar->setPen(QPen(look::kFault, 4, Qt::SolidLine, Qt::FlatCap));
  bar->setAdaptiveSampling(false);  // gaps are few, and none may be lost
  bar->data()->set(missing, false);
}

void TrialPlot::add_stretches(const TrialReplay& replay) {
  const auto t_s = replay.signals().column(columns::t_s);
  const auto phases = replay.signals().column(columns::phase);
  if (phases.empty()) return;
  const auto aside = [&](std::size_t row) {
    return phases[row] == static_cast<double>(tasks::Phase::lead_in) ||
           phases[row] == static_cast<double>(tasks::Phase::paused);
  };
  int count = 0;
  for (const auto& [first, behind] : runs(replay.rows(), aside)) {
    if (++count > kMostItems) return;
    auto* box = new QCPItemRect(plot_);  // the plot owns it
    box->topLeft->setAxes(plot_->xAxis, plot_->yAxis2);
    box->bottomRight->setAxes(plot_->xAxis, plot_->yAxis2);
    box->topLeft->setCoords(t_s[first], 1.0);
    box->bottomRight->setCoords(t_s[std::min(behind, t_s.size() - 1)], 0.0);
    box->setPen(Qt::NoPen);
    box->setBrush(kNotScored);
    box->setLayer("background");
  }
}

void TrialPlot::add_marks(const std::vector<TrialMark>& marks) {
  QFont bold = font();
  bold.setBold(true);
  int count = 0;
  for (const auto& mark : marks) {
    if (++count > kMostItems) return;
    const QColor colour = mark.kind == "fault" ? look::kFault : look::kQuietText;
    auto* line = new QCPItemLine(plot_);
    auto* letter = new QCPItemText(plot_);
    for (auto* position : {line->start, line->end, letter->position})
      position->setAxes(plot_->xAxis, plot_->yAxis2);
    line->start->setCoords(mark.t_s, 0.0);
    line->end->setCoords(mark.t_s, 1.0);
    line->setPen(QPen(colour, 1, Qt::DashDotLine));
    letter->position->setType(QCPItemPosition::ptPlotCoords);
    letter->position->setCoords(mark.t_s, 1.0);
    letter->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
    letter->setText(mark_letter(mark.kind));
    letter->setFont(bold);
    letter->setColor(colour);
    letter->setBrush(look::kCard);
    letter->setPadding({2, 0, 2, 0});
  }
}

void TrialPlot::show_trial(const TrialReplay& replay, const std::vector<TrialCurve>& curves,
                           const std::vector<TrialMark>& marks) {
  plot_->clearGraphs();
  for (int i = plot_->itemCount() - 1; i >= 0; --i)
    if (plot_->item(i) != cursor_) plot_->removeItem(i);
  const bool same = begin_s_ == replay.begin_s() && end_s_ == replay.end_s();
  begin_s_ = replay.begin_s();
  end_s_ = std::max(replay.end_s(), begin_s_ + kShortest_s);
  for (const auto& curve : curves) add_curve(replay, curve);
  bool found = false;
  QCPRange all(0.0, 1.0);
  QString unit;
  bool mixed = false;
  for (int i = 0; i < plot_->graphCount(); ++i) {
    bool one = false;
    const auto range = plot_->graph(i)->getValueRange(one);
    if (!one) continue;
    all = found ? all.expanded(range) : range;
    found = true;
  }
  for (const auto& curve : curves) {
    mixed = mixed || (!unit.isNull() && unit != curve.unit);
    unit = curve.unit.isNull() ? QStringLiteral("") : curve.unit;
  }
  add_missing(replay, curves);
  add_stretches(replay);
  add_marks(marks);
  const double room = all.size() > 0.0 ? 0.08 * all.size() : 1.0;
  plot_->yAxis->setRange(all.lower - room, all.upper + room);
  plot_->yAxis->setLabel(mixed ? tr("several units") : unit);
  if (!same) show_whole();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TrialPlot::show_whole() {
  show_stretch(begin_s_, end_s_);
}

void TrialPlot::show_stretch(double from_s, double to_s) {
  const double size_s = std::min(to_s - from_s, end_s_ - begin_s_);
  from_s = std::clamp(from_s, begin_s_, end_s_ - size_s);
  plot_->xAxis->setRange(from_s, from_s + size_s);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void TrialPlot::set_cursor(double t_s) {
  cursor_s_ = t_s;
  cursor_->point1->setCoords(t_s, 0.0);
  cursor_->point2->setCoords(t_s, 1.0);
  const auto seen = plot_->xAxis->range();
  if (!seen.contains(t_s))  // the picture goes along
    show_stretch(t_s - 0.1 * seen.size(), t_s + 0.9 * seen.size());
  plot_->layer("cursor")->replot();
}

void TrialPlot::zoom(bool in) {
  const double size_s = std::max(kShortest_s, plot_->xAxis->range().size() * (in ? 0.5 : 2.0));
  const double share = (cursor_s_ - plot_->xAxis->range().lower) / plot_->xAxis->range().size();
  const double from_s = cursor_s_ - std::clamp(share, 0.0, 1.0) * size_s;
  show_stretch(from_s, from_s + size_s);
}

void TrialPlot::seek_to(const QPoint& place) {
  const QPoint in_plot = plot_->mapFrom(this, place);
  Q_EMIT sought(std::clamp(plot_->xAxis->pixelToCoord(in_plot.x()), begin_s_, end_s_));
}

void TrialPlot::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) seek_to(event->pos());
}

void TrialPlot::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) seek_to(event->pos());
}

void TrialPlot::mouseDoubleClickEvent(QMouseEvent*) {
  show_whole();
}

void TrialPlot::wheelEvent(QWheelEvent* event) {
  if (event->angleDelta().y() != 0) zoom(event->angleDelta().y() > 0);
  event->accept();
}

void TrialPlot::keyPressEvent(QKeyEvent* event) {
  constexpr int kFar = 10;  // samples with Shift
  const int step = event->modifiers().testFlag(Qt::ShiftModifier) ? kFar : 1;
  switch (event->key()) {
    case Qt::Key_Left: Q_EMIT stepped(-step); break;
    case Qt::Key_Right: Q_EMIT stepped(step); break;
    case Qt::Key_Up: zoom(true); break;
    case Qt::Key_Down: zoom(false); break;
    case Qt::Key_Home: Q_EMIT sought(begin_s_); break;
    case Qt::Key_End: Q_EMIT sought(end_s_); break;
    default: event->ignore();
  }
}

void TrialPlot::paintEvent(QPaintEvent*) {
  if (!hasFocus()) return;
  QPainter painter(this);
  painter.setPen(QPen(look::kAccent, 2));
  painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

void TrialPlot::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void TrialPlot::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace isograsp::gui
