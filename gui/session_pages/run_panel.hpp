// SPDX-License-Identifier: GPL-3.0-or-later
// Running the work of a session: what comes next, start, pause; and what a therapist does
// between trials. The next act is the protocol's, or a task that is chosen here.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>

#include "gui/look/card.hpp"
#include "gui/look/score_row.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class RunPanel final : public Card {
  Q_OBJECT

 public:
  explicit RunPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 Q_SIGNALS:
  void report_wanted();  ///< the work is done

 private:
  void make_choice();
  void make_next();
  void make_buttons();
  void make_between();
  void fill_list();
  void pause_or_go_on();
  void refresh();
  void refresh_choice();
  void refresh_between();
  void refresh_progress();

  SessionPresenter& presenter_;
  QPushButton* follow_;
  QPushButton* by_hand_;
  QListWidget* list_;  ///< headings, and tasks with their number in the presenter as data
  QLabel* next_;
  QLabel* instruction_;
  QCheckBox* practice_;
  QCheckBox* by_itself_;
  QPushButton* show_how_;
  QLabel* not_shown_;  ///< why, in its place
  QPushButton* start_;
  QPushButton* pause_;
  QPushButton* end_report_;
  QPushButton* end_disconnect_;
  QProgressBar* progress_;
  QLabel* hint_;
  QPushButton* easier_;
  QPushButton* harder_;
  QLabel* level_;
  QPushButton* repeat_;
  QPushButton* skip_;
  QPushButton* helped_;
  QLineEdit* note_;
};

/// Effort and pain, 0 to 10 each, asked after every block of work; of a tracked hand shoulder pain,
/// too, after every bout of placements.
class RatingPanel final : public Card {
  Q_OBJECT

 public:
  explicit RatingPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  ScoreRow* effort_;
  ScoreRow* pain_;
  QLabel* shoulder_words_;
  ScoreRow* shoulder_;
  QLabel* remark_;
  QPushButton* correct_;
};

}  // namespace isograsp::gui
