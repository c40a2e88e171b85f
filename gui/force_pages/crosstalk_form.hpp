// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two empty platforms move each other: pressed one after the other, before hands go in.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class CrossTalkForm final : public QWidget {
  Q_OBJECT

 public:
  explicit CrossTalkForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* words_;
  QPushButton* check_;
  QPushButton* skip_;
};

}  // namespace isograsp::gui
