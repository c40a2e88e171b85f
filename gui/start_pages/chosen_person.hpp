// SPDX-License-Identifier: GPL-3.0-or-later
// Beside the cards where the window has the room: the chosen person's main measures and last
// sessions. Nothing is read while it is hidden.
#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>
#include <string>

#include "gui/clinic/clinic.hpp"
#include "gui/look/card.hpp"
#include "gui/record_pages/measure_trend.hpp"

namespace isograsp::gui {

class ChosenPerson final : public Card {
  Q_OBJECT

 public:
  explicit ChosenPerson(Clinic& clinic, QWidget* parent = nullptr);

  /// Empty: nobody is chosen.
  void show_person(const std::string& code);
  /// What is known of the person may have changed.
  void renew();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  struct Read {
    PatientCourse course;
    std::vector<MeasureTrend> trends;
  };
  void read();
  void show_read(const Read& read);
  void empty();

  Clinic& clinic_;
  std::string code_;
  int reading_ = 0;  ///< the newest one counts
  bool shown_ = false;
  QLabel* hint_;
  QVBoxLayout* tiles_;
  QLabel* sessions_;
};

}  // namespace isograsp::gui
