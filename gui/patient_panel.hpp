// SPDX-License-Identifier: GPL-3.0-or-later
// Patients by code: search, choose, add with a generated code; and the hand of this session.
#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include "gui/card.hpp"
#include "gui/clinic.hpp"
#include "gui/session_presenter.hpp"

namespace isograsp {

class PatientPanel final : public Card {
  Q_OBJECT

 public:
  PatientPanel(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void fill();
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  QLineEdit* search_;
  QListWidget* list_;
  QLabel* empty_;
  QPushButton* add_;
};

/// Which hand is in the device: asked every session, nothing is chosen beforehand.
class HandPanel final : public Card {
  Q_OBJECT

 public:
  explicit HandPanel(SessionPresenter& presenter, QWidget* parent = nullptr);

 private:
  void refresh();

  SessionPresenter& presenter_;
  QPushButton* left_;
  QPushButton* right_;
};

}  // namespace isograsp
