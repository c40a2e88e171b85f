// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software: sees target and object after a visual delay, plans, presses with three
// weak, noisy, coupled fingers. Knows the screen (Stimulus) and how the object answers to pushing
// (the scene), never the task's answer. Same seed, same forces.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "core/result.hpp"
#include "core/stimulus.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp {

/// What makes a person (docs/virtual_patient.md). Values of the presets are assumptions in a
/// plausible range: a software test instrument, not data.
struct PatientTraits {
  double visual_delay_s = 0.18;
  double reaction_s = 0.25;
  double movement_s = 1.8;         ///< of one planned movement
  double maximum_force_N = 60.0;   ///< per digit
  double enslaving = 0.05;         ///< share of a digit's force that spreads to its neighbour
  double muscle_lag_s = 0.04;      ///< each of two first-order lags
  double force_cv = 0.03;          ///< signal-dependent slow force noise, SD / mean
  double tremor_fraction = 0.005;  ///< amplitude / force
  double tremor_Hz = 9.0;
  double resting_force_N = 0.0;  ///< tone of each digit while relaxed
  double release_s = 0.1;        ///< time constant of letting go
  double prediction = 0.8;       ///< share of their own delay that they foresee of a moving target
};

/// "healthy" | "paretic"; nullopt for any other name.
[[nodiscard]] std::optional<PatientTraits> patient_traits(std::string_view name);

/// A person on the way from `traits` (fraction 0) to healthy (fraction 1), every trait linearly.
[[nodiscard]] PatientTraits recovered(const PatientTraits& traits, double fraction);

class VirtualPatient final : public FingerSource {
 public:
  VirtualPatient(const PatientTraits& traits, std::uint64_t seed);
  ~VirtualPatient() override;

  /// The object now on the screen (already turned for the hand), or none: the person learns how it
  /// answers. Not real-time safe; between trials only.
  void meet_object(const std::optional<Scene>& scene);

  void see(const Stimulus& stimulus) noexcept override;
  [[nodiscard]] FingerWrenches press(double t_s) noexcept override;

 private:
  struct Mind;
  std::unique_ptr<Mind> mind_;
};

}  // namespace isograsp
