// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a session: a line with its state, and below it what there is to do. Only the next
// step is open, unless the therapist opens another one.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "gui/rules/flow.hpp"

namespace isograsp::gui {

class StepSummary;

class StepSection final : public QFrame {
  Q_OBJECT

 public:
  /// `body` becomes its own. `place` among all steps names its widgets.
  StepSection(int place, const QString& title, QWidget* body, QWidget* parent = nullptr);

  /// Which of how many steps that are asked for; Alt+number opens it. 0: it is not asked for.
  void show_number(int number, int count);
  void set_title(const QString& title);
  /// `summary`: what came of it, e.g. "Right hand"; `folded`: what says so without the title.
  void show_state(StepState state, const QString& summary, const QString& folded);
  void open(bool open);
  [[nodiscard]] bool is_open() const { return body_->isVisibleTo(this); }
  /// One of many in a row: closed.
  void fold(bool folded);

 Q_SIGNALS:
  void opened();        ///< or closed
  void head_pressed();  ///< by hand: is about to be opened or closed

 private:
  void show_summary();

  int number_;
  int count_;
  QString title_;
  StepState state_ = StepState::open;
  QPushButton* head_;
  QLabel* mark_;
  QLabel* name_;
  QString words_;  ///< what came of it
  QString folded_words_;
  bool folded_ = false;
  StepSummary* summary_;
  QWidget* body_;
};

}  // namespace isograsp::gui
