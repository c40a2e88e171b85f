// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing and connecting the device, its state in words, the zero of the empty device, and the
// moment in which the hand is strapped.
#pragma once

#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>

#include "gui/card.hpp"
#include "gui/session_presenter.hpp"
#include "gui/state_light.hpp"

namespace isograsp {

class DevicePanel final : public Card {
  Q_OBJECT

 public:
  explicit DevicePanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void fill(const std::string& preset);
  void choose(int index);
  void choose_recording();
  void refresh();
  void refresh_progress();

  SessionPresenter& presenter_;
  QComboBox* devices_;
  QPushButton* connect_;
  StateLight* light_;
  QLabel* words_;
  QPushButton* zero_;
  QFrame* confirm_;  ///< instead of the button: the operator confirms that nothing touches
  QPushButton* confirmed_;
  QPushButton* not_yet_;
  QPushButton* changed_;  ///< only after a zero that was refused because it differs
  QPushButton* strapped_;
  QProgressBar* progress_;
};

}  // namespace isograsp
