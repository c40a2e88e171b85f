// SPDX-License-Identifier: GPL-3.0-or-later
// From the forces a person wants to the forces the fingertips make: wrong directions, coupling
// between fingers, the arm, tone, strength and fatigue, slow muscles, noise and tremor. Contact
// frames; SI units.
#pragma once

#include <array>

#include "core/random.hpp"
#include "hand/finger.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// Wanted force of each fingertip [N], contact frames.
using FingerForces = std::array<Vec3, kFingerCount>;

/// The share of a digit's strength that a force needs. It is 1 on the ellipsoid whose half axes are
/// the sideways strength (twice) and the closing or opening strength. Real-time safe.
[[nodiscard]] double strength_used(const PatientTraits& traits, const Vec3& force_C) noexcept;

/// A force turned by `angle_rad` towards closing and +x of the contact frame (the direction into
/// which all forces of a digit drift), at most into it. Real-time safe.
[[nodiscard]] Vec3 misdirected(const Vec3& force_C, double angle_rad) noexcept;

class Motor {
 public:
  Motor(const PatientTraits& traits, std::uint64_t seed);

  /// The forces after `dt_s` of wanting `wanted`. Tone never lets a normal force below the resting
  /// force, and a digit pulls only if the person wants one to open. No digit ever exceeds its
  /// strength. Real-time safe.
  [[nodiscard]] FingerWrenches step(const FingerForces& wanted, double dt_s) noexcept;
  /// The hand leaves the device: all forces are exactly zero, and strength recovers for `dt_s`.
  void take_away(double dt_s) noexcept;
  /// Share of the strength that is left.
  [[nodiscard]] double freshness() const noexcept { return 1.0 - fatigue_; }

 private:
  void advance_noise(double dt_s) noexcept;
  void advance_state(double effort, double dt_s) noexcept;
  void limit(Vec3& force_C) const noexcept;

  PatientTraits traits_;
  Random random_;
  FingerForces lag1_, lag2_;
  std::array<double, kFingerCount> wander_{};  ///< slow noise, SD 1
  std::array<double, kFingerCount> tremor_phase_rad_{};
  double tone_ = 0.0;     ///< slow memory of effort, 0 … 1
  double fatigue_ = 0.0;  ///< share of the strength lost
};

}  // namespace isograsp::virtual_patient
