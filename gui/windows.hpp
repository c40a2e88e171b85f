// SPDX-License-Identifier: GPL-3.0-or-later
// Both windows with what stands behind them; the program and the tests make them in the same way.
#pragma once

#include <memory>
#include <string>

#include "gui/clinic.hpp"
#include "gui/patient_window.hpp"
#include "gui/session_presenter.hpp"
#include "gui/therapist_window.hpp"

namespace isograsp {

class Windows {
 public:
  /// Needs a QApplication; opens the database in the background.
  explicit Windows(const GuiConfig& config);
  ~Windows();

  void show();
  /// Makes the patient's screen, or says in the therapist window why that is not possible.
  void show_patient_screen();

  [[nodiscard]] Clinic& clinic() noexcept { return clinic_; }
  [[nodiscard]] SessionPresenter& presenter() noexcept { return presenter_; }
  [[nodiscard]] TherapistWindow& therapist() noexcept { return therapist_; }
  /// Null until it was shown, or where there is no OpenGL.
  [[nodiscard]] PatientWindow* patient() noexcept { return patient_.get(); }

 private:
  Clinic clinic_;
  SessionPresenter presenter_;
  TherapistWindow therapist_;
  std::unique_ptr<PatientWindow> patient_;
};

}  // namespace isograsp
