// SPDX-License-Identifier: GPL-3.0-or-later
// From the forces a person wants to the forces the fingertips make: coupling between fingers,
// strength, slow muscles, noise and tremor. Contact frames; SI units.
#pragma once

#include <array>

#include "core/finger.hpp"
#include "core/random.hpp"
#include "virtual_patient/virtual_patient.hpp"

namespace isograsp {

/// Wanted force of each fingertip [N], contact frames.
using FingerForces = std::array<Vec3, kFingerCount>;

class Motor {
 public:
  Motor(const PatientTraits& traits, std::uint64_t seed);

  /// The forces after `dt_s` of wanting `wanted`. Tone never lets a normal force below the resting
  /// force; fingers push and never pull. Real-time safe.
  [[nodiscard]] FingerWrenches step(const FingerForces& wanted, double dt_s) noexcept;
  /// The hand leaves the device: all forces are exactly zero.
  void take_away() noexcept;

 private:
  void advance_noise(double dt_s) noexcept;

  PatientTraits traits_;
  Random random_;
  FingerForces lag1_, lag2_;
  std::array<double, kFingerCount> wander_{};  ///< slow noise, SD 1
  std::array<double, kFingerCount> tremor_phase_rad_{};
};

}  // namespace isograsp
