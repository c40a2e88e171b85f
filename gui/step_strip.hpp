// SPDX-License-Identifier: GPL-3.0-or-later
// The seven steps of a session in a row: done, next, still to come; by text, mark and colour.
#pragma once

#include <QLabel>
#include <QWidget>
#include <array>

#include "gui/flow.hpp"

namespace isograsp {

class StepStrip final : public QWidget {
  Q_OBJECT

 public:
  explicit StepStrip(QWidget* parent = nullptr);
  void show_steps(const std::array<StepState, kStepCount>& steps);

 private:
  std::array<QLabel*, kStepCount> labels_{};
  std::array<StepState, kStepCount> shown_{};
};

}  // namespace isograsp
