// SPDX-License-Identifier: GPL-3.0-or-later
// Covers the therapist's window while nobody is logged in: name, and password or PIN. It shows
// nothing of a patient.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>

#include "gui/clinic/staff.hpp"

namespace isograsp::gui {

class LoginPage final : public QWidget {
  Q_OBJECT

 public:
  explicit LoginPage(Staff& staff, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QWidget* make_card();
  void watch();
  void refresh();
  void fill_who();
  [[nodiscard]] bool who_is_filled() const;
  void log_in();
  [[nodiscard]] Staff::Key key() const;

  Staff& staff_;
  QLabel* title_;
  QLabel* why_;
  QComboBox* who_;
  QLabel* secret_caption_;
  QLineEdit* secret_;
  QPushButton* with_password_;
  QPushButton* enter_;
  QLabel* problem_;
  bool chosen_ = false;  ///< in the list, by hand
};

}  // namespace isograsp::gui
