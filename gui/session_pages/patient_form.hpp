// SPDX-License-Identifier: GPL-3.0-or-later
// First step of a session: who, and what suits this person on the screen.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "gui/look/choice_box.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class PatientForm final : public QWidget {
  Q_OBJECT

 public:
  explicit PatientForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 Q_SIGNALS:
  void other_patient();  ///< the therapist wants to choose one

 private:
  void refresh();

  SessionPresenter& presenter_;
  QPushButton* patients_;
  ChoiceBox* half_;
  std::array<QCheckBox*, 4> switches_{};
};

}  // namespace isograsp::gui
