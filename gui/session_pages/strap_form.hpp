// SPDX-License-Identifier: GPL-3.0-or-later
// Posture and straps, when the hand is put in, or both are: filled in as last time; one press
// confirms it.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/posture_fields.hpp"

namespace isograsp::gui {

class StrapForm final : public QWidget {
  Q_OBJECT

 public:
  explicit StrapForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_posture();

  SessionPresenter& presenter_;
  QLabel* posture_;
  QPushButton* edit_;
  PostureFields* fields_;
  QLabel* deviations_;
  QPushButton* strapped_;
  QLabel* words_;
};

}  // namespace isograsp::gui
