// SPDX-License-Identifier: GPL-3.0-or-later
// The first page: the day at a glance, a card for everybody; find or add a patient, begin a
// session; on the first start it offers a demonstration clinic.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>

#include "gui/clinic/clinic.hpp"
#include "gui/clinic/day_book.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/start_pages/chosen_person.hpp"
#include "gui/start_pages/visit_cards.hpp"

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
  void go_to_session();         ///< to the one that is open
  void open_patient();          ///< the chosen one
  void demonstration_wanted();  ///< a clinic of simulated patients, in a file of its own

 protected:
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] QLayout* make_search();
  [[nodiscard]] QWidget* make_first_start();
  void watch();
  void fill();
  void read_cards();
  void begin_with(const QString& code);
  void show_chosen();
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  Staff& staff_;
  DayBook* book_;
  QLineEdit* search_;
  QPushButton* names_;
  QPushButton* add_;
  VisitCards* cards_;
  ChosenPerson* chosen_;  ///< hidden in a window without the room
  QLabel* empty_;         ///< why there is no card, or how many more there are
  QWidget* first_start_;
  QPushButton* demonstration_;
  bool making_ = false;
  std::vector<storage::PatientRecord> shown_;  ///< whose cards there are
};

}  // namespace isograsp::gui
