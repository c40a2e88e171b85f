// SPDX-License-Identifier: GPL-3.0-or-later
// Following a force target on the screen: what is seen is late, so a steady movement of the target
// is foreseen and the error on the screen corrects the rest. Grip = min(thumb, index + middle) [N].
#pragma once

#include "core/stimulus.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp {

class GripSkill {
 public:
  explicit GripSkill(const PatientTraits& traits) : traits_(traits) {}

  /// Begins anew: nothing seen, nothing learned.
  void begin() noexcept { *this = GripSkill(traits_); }
  /// A perceived picture, in the order of time. Real-time safe.
  void perceive(const Stimulus& picture) noexcept;
  /// The grip wanted [N]. Real-time safe.
  [[nodiscard]] double wanted_N() const noexcept;

 private:
  PatientTraits traits_;
  bool seen_ = false;
  double first_s_ = 0.0;
  double latest_s_ = 0.0;
  double target_N_ = 0.0;
  double slope_N_s_ = 0.0;     ///< of the target, smoothed
  double correction_N_ = 0.0;  ///< integral of the seen error
};

}  // namespace isograsp
