// SPDX-License-Identifier: GPL-3.0-or-later
// The first page: find or add a patient, begin a session; on the first start it offers a
// demonstration clinic.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>
#include <map>
#include <vector>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"

namespace isograsp::gui {

class StartPage final : public QWidget {
  Q_OBJECT

 public:
  StartPage(Clinic& clinic, SessionPresenter& presenter, Staff& staff, QWidget* parent = nullptr);

  /// The demonstration clinic can be asked for; `making`: it is being made.
  void offer_demonstration(bool making);
  [[nodiscard]] bool making_demonstration() const noexcept { return making_; }

 Q_SIGNALS:
  void renewed();               ///< after everything that is shown
  void begin_session();         ///< of the chosen patient
  void open_patient();          ///< the chosen one
  void demonstration_wanted();  ///< a clinic of simulated patients, in a file of its own

 private:
  [[nodiscard]] QWidget* make_patients();
  [[nodiscard]] QWidget* make_recent();
  [[nodiscard]] QWidget* make_first_start();
  void fill();
  void load_recent();
  void fill_recent(const std::vector<storage::SessionRecord>& sessions);
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  Staff& staff_;
  QLineEdit* search_;
  QPushButton* names_;
  QListWidget* list_;
  QLabel* empty_;
  QPushButton* add_;
  QPushButton* begin_;
  QPushButton* open_;
  QTableWidget* recent_;
  QLabel* no_recent_;
  QWidget* first_start_;
  QPushButton* demonstration_;
  bool making_ = false;
  std::map<storage::RowId, storage::SessionRecord> newest_;  ///< session, by patient
};

}  // namespace isograsp::gui
