// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient's screen shows now, and what is stored of how it was shown. GUI thread.
#pragma once

#include <optional>

#include "gui/presenter/act_context.hpp"

namespace isograsp::gui {

class PatientView {
 public:
  explicit PatientView(const ActContext& with);

  /// On a content area of that height (0: not known).
  [[nodiscard]] PatientPicture picture(double picture_height_m = 0.0) const;
  /// A picture has appeared on the patient's screen: its age, and how large a force is on it, are
  /// kept with the trial.
  void picture_shown(const PatientPicture& picture);
  /// What the therapist said of how the patient sees has changed; while a session is open it is
  /// stored with it.
  void store_presentation();

 private:
  [[nodiscard]] PatientFacts facts() const;
  void say_smaller_gain(std::optional<double> shown);

  SessionState& state_;
  SessionFlow& flow_;
  const SettingsFile& settings_;
  const Seating& seating_;
  const ExamplePlayer& example_;
  const Clock& clock_;
};

}  // namespace isograsp::gui
