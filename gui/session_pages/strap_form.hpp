// SPDX-License-Identifier: GPL-3.0-or-later
// Posture and straps, when the hand is put in: filled in as last time; one press confirms it.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>
#include <array>

#include "gui/look/choice_box.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class StrapForm final : public QWidget {
  Q_OBJECT

 public:
  explicit StrapForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  [[nodiscard]] QWidget* make_fields();
  void say();
  void refresh();

  SessionPresenter& presenter_;
  QLabel* posture_;
  QPushButton* edit_;
  QWidget* fields_;
  std::array<ChoiceBox*, kPostureItems> choices_{};  ///< null: it is written
  std::array<QLineEdit*, kPostureItems> written_{};  ///< null: it is chosen
  QLabel* deviations_;
  QPushButton* strapped_;
  QLabel* words_;
};

}  // namespace isograsp::gui
