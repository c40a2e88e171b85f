// SPDX-License-Identifier: GPL-3.0-or-later
// The result of the running trial, renewed every second, or of the last one: the measure by which
// it is known at a glance in one large number, with that of last time beside it; all the others one
// key away.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <memory>

#include "gui/clinic/clinic.hpp"
#include "gui/look/card.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class ScorePanel final : public Card {
  Q_OBJECT

 public:
  ScorePanel(const Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  [[nodiscard]] const tasks::TaskSpec* task();
  [[nodiscard]] TrialLike trial_like(const tasks::TaskSpec& task) const;
  [[nodiscard]] QString remark() const;
  void refresh();
  void show_key();
  void show_all();

  const Clinic& clinic_;
  SessionPresenter& presenter_;
  QPushButton* all_;
  QLabel* key_value_;
  QLabel* key_title_;
  QLabel* last_time_;
  QLabel* remark_;
  QTableWidget* table_;
  storage::RowId read_ = 0;  ///< the trial whose task is `read_task_`
  std::shared_ptr<const tasks::TaskSpec> read_task_;
};

}  // namespace isograsp::gui
