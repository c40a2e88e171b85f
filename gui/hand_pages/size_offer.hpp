// SPDX-License-Identifier: GPL-3.0-or-later
// For a hand that cannot open: its size may be that of the other one, once a tracker has measured
// that. Not offered otherwise; asked anew in every session.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QWidget>

#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class SizeOffer final : public QWidget {
  Q_OBJECT

 public:
  explicit SizeOffer(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QCheckBox* take_;
  QLabel* from_;
};

/// "Size: that of the left hand, entry test of 2026-03-05."; empty: the hand has its own.
[[nodiscard]] QString size_words(const SessionState& state);

}  // namespace isograsp::gui
