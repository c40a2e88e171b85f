// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be heard when the patient's picture changes: decided without a loudspeaker. Pure but
// for what was shown last.
#pragma once

#include <optional>
#include <string>

#include "gui/picture/patient_picture.hpp"
#include "gui/picture/presentation.hpp"
#include "gui/picture/tones.hpp"

namespace isograsp::gui {

struct Sounds {
  std::optional<Tone> tone;
  std::optional<std::string> words;  ///< to be spoken
  HeardForce force;
};

class Soundtrack {
 public:
  /// Of the next picture. Nothing sounds over a pause or a fault.
  [[nodiscard]] Sounds next(const PatientPicture& picture, const Presentation& presentation);

 private:
  bool any_ = false;
  PatientPicture::Sign sign_ = PatientPicture::Sign::wait;
  bool urgent_ = false;
  bool missed_ = false;
  int targets_reached_ = 0;
  std::string spoken_;
};

}  // namespace isograsp::gui
