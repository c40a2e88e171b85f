// SPDX-License-Identifier: GPL-3.0-or-later
// Before both hands go in: the stop is tested, somebody stays within reach, and the less affected
// hand lies unstrapped in its supports, or it is said that it is strapped.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class SafetyForm final : public QWidget {
  Q_OBJECT

 public:
  explicit SafetyForm(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QLabel* stop_;
  QPushButton* reach_;
  QLabel* supports_;
  QCheckBox* strapped_too_;
};

}  // namespace isograsp::gui
