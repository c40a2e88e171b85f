// SPDX-License-Identifier: GPL-3.0-or-later
// The screening of both hands before they work at once: the questions of each, one hand after the
// other, and which outcome holds.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/force_pages/screening_form.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class BothScreeningForm final : public QWidget {
  Q_OBJECT

 public:
  explicit BothScreeningForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void show_hand(Hand hand);
  void refresh();

  SessionPresenter& presenter_;
  Hand shown_ = Hand::left;
  OfHands<bool> complete_;  ///< when it was looked at last: the next hand follows by itself
  OfHands<QPushButton*> heads_;
  OfHands<ScreeningForm*> forms_;
  QLabel* outcome_;
};

}  // namespace isograsp::gui
