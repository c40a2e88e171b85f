// SPDX-License-Identifier: GPL-3.0-or-later
// One measure over the sessions of a patient: every trial a point, the sessions' means a line.
#pragma once

#include <QWidget>

#include "gui/record_pages/measure_trend.hpp"

class QCustomPlot;
class QCPGraph;

namespace isograsp::gui {

/// A disc is an assessment, a ring practice, a triangle a helped trial.
class SessionTrendPlot final : public QWidget {
  Q_OBJECT

 public:
  enum class Size : std::uint8_t { small, large };
  explicit SessionTrendPlot(Size size, QWidget* parent = nullptr);
  void show_trend(const MeasureTrend& trend);

 private:
  Size size_;
  QCustomPlot* plot_;
  QCPGraph* means_;
  QCPGraph* assessed_;
  QCPGraph* practised_;
  QCPGraph* helped_;
};

}  // namespace isograsp::gui
