// SPDX-License-Identifier: GPL-3.0-or-later
// Scrolling grip forces of both hands and of their sum, each with its target (dashed), over the
// last seconds.
#pragma once

#include <QWidget>
#include <array>

#include "gui/look/hands_history.hpp"

class QCustomPlot;
class QCPGraph;
class QCPItemText;

namespace isograsp::gui {

class HandsPlot final : public QWidget {
  Q_OBJECT

 public:
  explicit HandsPlot(QWidget* parent = nullptr);
  void show_forces(const HandsHistory& history);

 private:
  static constexpr std::size_t kCurves = 3;  // left, right, sum

  QCustomPlot* plot_;
  std::array<QCPGraph*, kCurves> forces_{};
  std::array<QCPGraph*, kCurves> targets_{};
  std::array<QCPItemText*, kCurves> labels_{};
};

}  // namespace isograsp::gui
