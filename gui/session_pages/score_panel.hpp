// SPDX-License-Identifier: GPL-3.0-or-later
// Measures of the running trial, renewed every second; afterwards its stored result.
#pragma once

#include <QLabel>
#include <QTableWidget>

#include "gui/look/card.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ScorePanel final : public Card {
  Q_OBJECT

 public:
  explicit ScorePanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* remark_;
  QTableWidget* table_;
};

}  // namespace isograsp::gui
