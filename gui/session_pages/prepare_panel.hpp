// SPDX-License-Identifier: GPL-3.0-or-later
// The left column of a session: its steps in order, the next one open.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <array>
#include <functional>

#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/step_section.hpp"

namespace isograsp::gui {

class PreparePanel final : public QWidget {
  Q_OBJECT

 public:
  PreparePanel(SessionPresenter& presenter, Staff& staff, QWidget* parent = nullptr);

 Q_SIGNALS:
  void other_patient();  ///< the therapist wants to choose one

 private:
  [[nodiscard]] QWidget* make_hand();
  [[nodiscard]] QWidget* make_screening();
  [[nodiscard]] QWidget* make_zero();
  [[nodiscard]] QString summary_of(Step step) const;
  void name_sides();
  void refresh();

  SessionPresenter& presenter_;
  QPushButton* left_;
  QPushButton* right_;
  QPushButton* both_;
  QPushButton* confirm_hand_;
  std::array<StepSection*, kStepCount> sections_{};
};

}  // namespace isograsp::gui
