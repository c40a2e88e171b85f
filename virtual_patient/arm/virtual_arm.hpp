// SPDX-License-Identifier: GPL-3.0-or-later
// An arm in software: it carries an object with markers, sees object and reference on the screen
// after a visual delay, and brings the one to the other. Knows nothing of the task but the screen
// (Stimulus). Same traits, seed, hand and day: same markers, bit for bit.
//
// Left arms: the markers are what cameras see, the reflection x -> -x of those of the right arm of
// the same person; the object is the same object for both, so that one rig serves both. The
// screen's X_WO and X_WT are those of the house, in the reflected world (docs/conventions.md, Left
// hands): for this person all is as with a right arm.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "hand/finger.hpp"
#include "hand/marker_source.hpp"
#include "virtual_patient/arm/arm_body.hpp"
#include "virtual_patient/arm/arm_traits.hpp"

namespace isograsp::virtual_patient {

class VirtualArm final : public MarkerSource {
 public:
  /// One person of these traits: drawn(traits, seed). On a day (arm_on_day()) it is the same person
  /// in another form, with markers placed anew and other noise.
  VirtualArm(const ArmTraits& traits, std::uint64_t seed, Hand hand = Hand::right,
             std::optional<std::uint64_t> day = {});
  ~VirtualArm() override;

  /// B1-3, EL, F1-2, W, D1-2, O1-6, T1.
  [[nodiscard]] std::span<const std::string> labels() const noexcept override;
  /// Pictures are seen when they come, on the time axis of markers(): their own t_s does not count.
  void see(const Stimulus& stimulus) noexcept override;
  void markers(double t_s, std::span<Vec3> p_W) noexcept override;

  /// Who this is, for tests and for postures made by calculation: a right arm.
  [[nodiscard]] const ArmTraits& person() const noexcept;
  [[nodiscard]] const ArmBody& body() const noexcept;
  /// The posture of the last picture of the cameras.
  [[nodiscard]] const Joints& posture() const noexcept;

 private:
  struct Mind;
  std::unique_ptr<Mind> mind_;
};

}  // namespace isograsp::virtual_patient
