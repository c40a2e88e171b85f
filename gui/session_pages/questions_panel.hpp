// SPDX-License-Identifier: GPL-3.0-or-later
// The questions of a task about its last trial, one row of numbers each. Every press is kept at
// once; another one corrects it. Shown while there is something to ask. GUI thread.
#pragma once

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <vector>

#include "gui/look/card.hpp"
#include "gui/look/score_row.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class QuestionsPanel final : public Card {
  Q_OBJECT

 public:
  explicit QuestionsPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 protected:
  /// Lines that wrap need room that no layout asks for: it would be taken from the cards around.
  void resizeEvent(QResizeEvent* event) override;

 private:
  void refresh();
  void build(const tasks::Questionnaire& asked);

  SessionPresenter& presenter_;
  const tasks::Questionnaire* shown_ = nullptr;
  QWidget* questions_ = nullptr;
  struct Row {
    ScoreRow* numbers;
    QToolButton* none;
  };
  std::vector<Row> rows_;
  QLabel* scale_;
};

}  // namespace isograsp::gui
