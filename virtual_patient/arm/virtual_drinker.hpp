// SPDX-License-Identifier: GPL-3.0-or-later
// A person in software who drinks from a glass when the screen asks for it: reaches, brings it to
// the mouth, drinks, puts it back and lays the hand down. Markers of library/rigs/drinking.toml on
// hand, wrist, elbow, shoulder, breastbone, face and glass. Who moves slowly and in pieces
// (ArmTraits::movement_s, first_gain) and leans (trunk_share) does so here. W as in arm_body.hpp:
// X right, Y up from the table, Z towards the person; of a left arm its reflection. Same traits,
// seed, hand and day: same markers, bit for bit.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "hand/finger.hpp"
#include "hand/marker_source.hpp"
#include "virtual_patient/arm/arm_traits.hpp"

namespace isograsp::virtual_patient {

class VirtualDrinker final : public MarkerSource {
 public:
  /// As VirtualArm.
  VirtualDrinker(const ArmTraits& traits, std::uint64_t seed, Hand hand = Hand::right,
                 std::optional<std::uint64_t> day = {});
  ~VirtualDrinker() override;

  /// HAND, WRIST, ELBOW, SHOULDER, TRUNK, FACE, GLASS.
  [[nodiscard]] std::span<const std::string> labels() const noexcept override;
  void see(const Stimulus& stimulus) noexcept override;
  void markers(double t_s, std::span<Vec3> p_W) noexcept override;

  /// The names of labels().
  [[nodiscard]] static std::span<const std::string_view> names() noexcept;

 private:
  struct Body;
  std::unique_ptr<Body> body_;
};

}  // namespace isograsp::virtual_patient
