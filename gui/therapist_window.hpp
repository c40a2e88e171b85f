// SPDX-License-Identifier: GPL-3.0-or-later
// The therapist's window: header with the state in one sentence, the steps, and all panels.
#pragma once

#include <QLabel>
#include <QMainWindow>
#include <QPushButton>
#include <functional>

#include "gui/clinic.hpp"
#include "gui/session_presenter.hpp"
#include "gui/state_light.hpp"
#include "gui/step_strip.hpp"

namespace isograsp {

class TherapistWindow final : public QMainWindow {
  Q_OBJECT

 public:
  TherapistWindow(Clinic& clinic, SessionPresenter& presenter, QWidget* parent = nullptr);

  /// Shows the patient's screen, or why that is not possible.
  std::function<void()> show_patient_screen;
  /// Called when this window has closed.
  std::function<void()> on_closed;
  /// A sentence for a few seconds, e.g. why an act was refused.
  void say(const QString& words);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* make_header();
  QWidget* make_body();
  void add_shortcuts();
  void refresh();

  Clinic& clinic_;
  SessionPresenter& presenter_;
  StateLight* light_;
  QLabel* sentence_;
  QLabel* simulated_;
  QPushButton* patient_screen_;
  StepStrip* steps_;
  QLabel* message_;
  bool closing_ = false;
};

}  // namespace isograsp
