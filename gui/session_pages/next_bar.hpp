// SPDX-License-Identifier: GPL-3.0-or-later
// The bar above every page: where the session stands in one sentence, the one thing to do next, and
// Stop. Its button is the only filled one of the window.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"
#include "gui/session_pages/state_light.hpp"

namespace isograsp::gui {

class NextBar final : public QFrame {
  Q_OBJECT

 public:
  explicit NextBar(SessionPresenter& presenter, QWidget* parent = nullptr);

  /// Where what is next is marked (mark_next): the start page while it is shown, else the
  /// session's.
  void follow(QWidget& page);
  /// … and before that here.
  void put_first(QWidget& part) { first_ = &part; }
  /// Says what is next after everything on that page has been renewed.
  void refresh();
  /// Does what the button says. Where something has to be chosen (a patient, a hand, an answer, a
  /// device), nothing is chosen: chooses() leads to where people do it.
  void press();

 Q_SIGNALS:
  void chooses(QWidget* first);  ///< of what there is to choose from

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void say(const QString& words);

  SessionPresenter& presenter_;
  QWidget* first_ = nullptr;
  QWidget* page_ = nullptr;
  StateLight* light_;
  QLabel* sentence_;
  QPushButton* next_;
  QPushButton* stop_;
  QPointer<QWidget> marked_;  ///< what the button stands for
};

}  // namespace isograsp::gui
