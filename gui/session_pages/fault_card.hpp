// SPDX-License-Identifier: GPL-3.0-or-later
// A fault, above every page: what happened, what is safe, what to do, and Try again. Hidden while
// there is none.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class FaultCard final : public QFrame {
  Q_OBJECT

 public:
  explicit FaultCard(SessionPresenter& presenter, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* happened_;
  QLabel* safe_;
  QLabel* remedy_;
  QPushButton* again_;
};

}  // namespace isograsp::gui
