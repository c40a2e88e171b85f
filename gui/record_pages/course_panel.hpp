// SPDX-License-Identifier: GPL-3.0-or-later
// The patient's sessions, newest first, and the trials of the chosen one.
#pragma once

#include <QListWidget>
#include <memory>

#include "gui/clinic/patient_course.hpp"
#include "gui/look/card.hpp"

namespace isograsp::gui {

class CoursePanel final : public Card {
  Q_OBJECT

 public:
  explicit CoursePanel(QWidget* parent = nullptr);

  /// The session that was chosen stays so if it is still there; otherwise the newest one is.
  void show_course(std::shared_ptr<const PatientCourse> course);

  /// Indices as in trial_opened(); opens nothing.
  void choose(int session_index, int trial_index);

 Q_SIGNALS:
  /// Indices into PatientCourse::sessions and CourseSession::trials.
  void trial_opened(int session, int trial);

 private:
  void fill_trials(int row);
  void open_row(int row);
  [[nodiscard]] int session_of_row(int row) const;

  std::shared_ptr<const PatientCourse> course_;
  QListWidget* sessions_;
  QLabel* trials_title_;
  QListWidget* trials_;
};

}  // namespace isograsp::gui
