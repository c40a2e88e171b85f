// SPDX-License-Identifier: GPL-3.0-or-later
// Live forces and the short history. With trend_plot and trial_plot the only files that use the
// plotting library. Pens of live curves are 1 px wide: wider ones cost twenty
// times as much.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "gui/look/force_history.hpp"
#include "hand/finger.hpp"

class QCustomPlot;
class QCPGraph;
class QCPItemText;

namespace isograsp::gui {

/// Scrolling normal forces of three fingers and the target over the last seconds.
class LivePlot final : public QWidget {
  Q_OBJECT

 public:
  explicit LivePlot(QWidget* parent = nullptr);
  void show_forces(const ForceHistory& history);

 private:
  void place_labels(const ForcePoint& last);

  QCustomPlot* plot_;
  std::array<QCPGraph*, kFingerCount> fingers_{};
  std::array<QCPItemText*, kFingerCount> labels_{};
  QCPGraph* target_;
};

/// One measure over the trials of a patient.
struct TrendPoint {
  double value = 0.0;
  bool practice = false;  ///< drawn hollow
};
class TrendPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit TrendPlot(QWidget* parent = nullptr);
  void show_trend(const std::vector<TrendPoint>& points, const QString& axis);

 private:
  QCustomPlot* plot_;
  QCPGraph* line_;
  QCPGraph* assessed_;
  QCPGraph* practised_;
};

}  // namespace isograsp::gui
