// SPDX-License-Identifier: GPL-3.0-or-later
// Any two sessions of the patient side by side, measure by measure.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QTableWidget>
#include <memory>

#include "gui/look/card.hpp"
#include "gui/record_pages/session_comparison.hpp"

namespace isograsp::gui {

class ComparisonPanel final : public Card {
  Q_OBJECT

 public:
  explicit ComparisonPanel(QWidget* parent = nullptr);

  /// Begins with the newest session and the oldest one that it may be compared with.
  void show_course(std::shared_ptr<const PatientCourse> course);
  void take_focus() { first_->setFocus(); }

 private:
  void compare();
  void fill(const SessionComparison& comparison);

  std::shared_ptr<const PatientCourse> course_;
  QComboBox* first_;
  QComboBox* second_;
  QCheckBox* all_;
  QTableWidget* table_;
  QLabel* remark_;
};

}  // namespace isograsp::gui
