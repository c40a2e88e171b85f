// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/windows.hpp"

#include <QGuiApplication>
#include <QScreen>

namespace isograsp {

Windows::Windows(const GuiConfig& config)
    : clinic_(config.database), presenter_(config, clinic_), therapist_(clinic_, presenter_) {
  therapist_.show_patient_screen = [this] { show_patient_screen(); };
  therapist_.on_closed = [this] {
    if (patient_ != nullptr) patient_->close();
  };
  clinic_.open();
}

Windows::~Windows() = default;

void Windows::show() {
  therapist_.show();
  // A second display is there for the patient.
  if (QGuiApplication::screens().size() > 1) show_patient_screen();
}

void Windows::show_patient_screen() {
  if (patient_ == nullptr) {
    if (const auto why = why_no_opengl(); !why.empty()) {
      therapist_.say(QString::fromStdString(why));
      return;
    }
    patient_ = std::make_unique<PatientWindow>(presenter_);
    patient_->show_for_patient();
    return;
  }
  if (!patient_->isVisible())
    patient_->show_for_patient();
  else
    patient_->toggle_full_screen();
}

}  // namespace isograsp
