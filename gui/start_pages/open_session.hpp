// SPDX-License-Identifier: GPL-3.0-or-later
// Above the cards: the session that is still open, for whoever comes next. Hidden while there is
// none.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class OpenSessionStrip final : public QFrame {
  Q_OBJECT

 public:
  explicit OpenSessionStrip(SessionPresenter& presenter, QWidget* parent = nullptr);

 Q_SIGNALS:
  void go_to_session();

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* words_;
  QPushButton* go_;
  QPushButton* end_;
};

}  // namespace isograsp::gui
