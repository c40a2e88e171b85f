// SPDX-License-Identifier: GPL-3.0-or-later
// The start posture of an arm: whether it is in sight and still, as a light with words, and the
// button that measures it.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/state_light.hpp"

namespace isograsp::gui {

class PostureForm final : public QWidget {
  Q_OBJECT

 public:
  explicit PostureForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_light();

  SessionPresenter& presenter_;
  StateLight* light_;
  QLabel* words_;
  QPushButton* measure_;
  QProgressBar* progress_;
};

}  // namespace isograsp::gui
