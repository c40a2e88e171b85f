// SPDX-License-Identifier: GPL-3.0-or-later
// The delay from an intention until its effect on the screen is perceived.
#pragma once

#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// Sensor (32 ms) and half a frame and its hold: what a person has learned of the device.
inline constexpr double kLearnedDeviceDelay_s = 0.040;

[[nodiscard]] inline double loop_delay_s(const PatientTraits& traits) noexcept {
  return traits.visual_delay_s + 2.0 * traits.muscle_lag_s + kLearnedDeviceDelay_s;
}

}  // namespace isograsp::virtual_patient
