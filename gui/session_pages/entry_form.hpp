// SPDX-License-Identifier: GPL-3.0-or-later
// The entry test of a tracked hand: whether the hand is seen, as a light with words; the button
// that begins the test, how far it is, and what came of it.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/state_light.hpp"

namespace isograsp::gui {

class EntryForm final : public QWidget {
  Q_OBJECT

 public:
  explicit EntryForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();
  void refresh_light();
  void refresh_running(bool runs);

  SessionPresenter& presenter_;
  StateLight* light_;
  QLabel* words_;
  QLabel* size_;  ///< whose it is, if it is not its own
  QPushButton* begin_;
  QProgressBar* progress_;
  QLabel* result_;
};

}  // namespace isograsp::gui
