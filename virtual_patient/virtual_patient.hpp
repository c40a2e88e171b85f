// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software: sees target and object after a visual delay, plans, presses with three
// weak, noisy, coupled fingers. Knows only the screen (Stimulus) and how the object answers to
// pushing (the scene), nothing else of the task. Same seed, same forces.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "grasp_model/scene.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/carry_skill.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

class VirtualPatient final : public FingerSource {
 public:
  VirtualPatient(const PatientTraits& traits, std::uint64_t seed);
  ~VirtualPatient() override;

  /// The object now on the screen (already turned for the hand), or none: the person learns how it
  /// answers. Not real-time safe; between trials only.
  void meet_object(const std::optional<Scene>& scene);

  /// The hand is one of two that are points and carry an object, or none. Between trials only.
  void meet_point(const std::optional<CarryKnown>& known) noexcept;
  /// What it makes of that; null: it is none.
  [[nodiscard]] const CarrySkill* carrying() const noexcept;

  void see(const Stimulus& stimulus) noexcept override;
  [[nodiscard]] FingerWrenches press(double t_s) noexcept override;

  /// Instructions that they did not notice in time, and efforts given up in pain, so far. On the
  /// thread that presses.
  [[nodiscard]] int missed_cues() const noexcept;
  [[nodiscard]] int pain_stops() const noexcept;

 private:
  struct Mind;
  std::unique_ptr<Mind> mind_;
};

}  // namespace isograsp::virtual_patient
