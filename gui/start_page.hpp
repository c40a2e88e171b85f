// SPDX-License-Identifier: GPL-3.0-or-later
// Where a day begins: find or add a patient, begin a session; on the first start a look around.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include "gui/clinic.hpp"
#include "gui/session_presenter.hpp"

namespace isograsp {

class StartPage final : public QWidget {
  Q_OBJECT

 public:
  StartPage(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

 Q_SIGNALS:
  void begin_session();         ///< of the chosen patient
  void open_patient();          ///< the chosen one
  void demonstration_wanted();  ///< a clinic of simulated patients, in a file of its own

 private:
  [[nodiscard]] QWidget* make_patients();
  [[nodiscard]] QWidget* make_recent();
  [[nodiscard]] QWidget* make_first_start();
  void fill();
  void fill_recent();
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  QLineEdit* search_;
  QListWidget* list_;
  QLabel* empty_;
  QPushButton* add_;
  QPushButton* begin_;
  QPushButton* open_;
  QTableWidget* recent_;
  QLabel* no_recent_;
  QWidget* first_start_;
  QPushButton* demonstration_;
};

}  // namespace isograsp
