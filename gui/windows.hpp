// SPDX-License-Identifier: GPL-3.0-or-later
// Both windows with what stands behind them; the program and the tests make them in the same way.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gui/clinic/backup_work.hpp"
#include "gui/clinic/clinic.hpp"
#include "gui/clinic/person_file.hpp"
#include "gui/clinic/settings.hpp"
#include "gui/clinic/staff.hpp"
#include "gui/patient_screen/patient_window.hpp"
#include "gui/presenter/session_presenter.hpp"
#include "gui/therapist_window.hpp"

namespace isograsp::gui {

class Windows {
 public:
  /// Needs a QApplication; opens the database in the background, a protected one after a login.
  explicit Windows(const GuiConfig& config);
  ~Windows();

  void show();
  /// Makes and opens a demonstration clinic in the place of this one.
  std::function<void()> open_demonstration;
  /// Makes the patient's screen, or says in the therapist window why that is not possible.
  void show_patient_screen();

  [[nodiscard]] Clinic& clinic() noexcept { return clinic_; }
  [[nodiscard]] PersonFile& person_file() noexcept { return person_file_; }
  [[nodiscard]] SessionPresenter& presenter() noexcept { return presenter_; }
  [[nodiscard]] SettingsFile& settings() noexcept { return settings_; }
  [[nodiscard]] Staff& staff() noexcept { return staff_; }
  /// Replaced by another one after a change of language or size of letters; the session goes on.
  [[nodiscard]] TherapistWindow& therapist() noexcept { return *therapist_; }
  /// Null until it was shown, or where there is no OpenGL.
  [[nodiscard]] PatientWindow* patient() noexcept { return patient_.get(); }

 private:
  void make_therapist();
  void watch_staff();
  void follow_staff();
  void log_what_leaves();
  void apply_settings();

  SettingsFile settings_;
  Settings applied_;
  Staff staff_;
  bool closed_ = false;             ///< when it was looked last
  std::optional<bool> reads_only_;  ///< the database is open so; nothing: not open yet
  Clinic clinic_;
  PersonFile person_file_;
  BackupWork backups_;
  bool look_only_;  ///< another program works with the file
  SessionPresenter presenter_;
  std::unique_ptr<QObject> clutch_pedal_;
  std::unique_ptr<TherapistWindow> therapist_;
  std::unique_ptr<PatientWindow> patient_;
};

}  // namespace isograsp::gui
