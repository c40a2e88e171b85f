// SPDX-License-Identifier: GPL-3.0-or-later
// "Now the left hand": ends the session of one hand and begins that of the other on the same
// device. Hidden while that cannot be done.
#pragma once

#include <QPushButton>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class OtherHandButton final : public QPushButton {
  Q_OBJECT

 public:
  OtherHandButton(SessionPresenter& presenter, const char* name, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
};

}  // namespace isograsp::gui
