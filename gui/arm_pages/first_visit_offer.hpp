// SPDX-License-Identifier: GPL-3.0-or-later
// Where an arm meets the cameras for the first time: the protocol that makes it familiar with its
// tasks, if the library has one, before anything is connected. Nobody has to take it.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class FirstVisitOffer final : public QFrame {
  Q_OBJECT

 public:
  explicit FirstVisitOffer(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* words_;
  QPushButton* take_;
};

}  // namespace isograsp::gui
