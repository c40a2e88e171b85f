// SPDX-License-Identifier: GPL-3.0-or-later
// The task: choosing it, running it, its score while it runs and its result.
#pragma once

#include <QCheckBox>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>

#include "gui/card.hpp"
#include "gui/session_presenter.hpp"

namespace isograsp {

class TaskPanel final : public Card {
  Q_OBJECT

 public:
  explicit TaskPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void fill_list();
  void refresh();
  void refresh_progress();

  SessionPresenter& presenter_;
  QListWidget* list_;  ///< headings, and tasks with their number in the presenter as data
  QLabel* instruction_;
  QCheckBox* practice_;
  QPushButton* show_how_;
  QPushButton* start_;
  QPushButton* pause_;
  QPushButton* stop_;
  QLabel* hint_;
  QProgressBar* progress_;
};

/// Measures of the running trial, renewed every second; afterwards its stored result.
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

}  // namespace isograsp
