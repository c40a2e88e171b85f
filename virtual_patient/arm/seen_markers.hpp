// SPDX-License-Identifier: GPL-3.0-or-later
// What cameras make of the markers of an arm: skin that moves on the bone, noise, and markers that
// are lost when they turn away.
#pragma once

#include <array>
#include <span>

#include "core/random.hpp"
#include "virtual_patient/arm/arm_body.hpp"
#include "virtual_patient/arm/arm_traits.hpp"

namespace isograsp::virtual_patient {

class SeenMarkers {
 public:
  SeenMarkers(const ArmTraits& traits, std::uint64_t seed) noexcept;

  /// The markers of `body` with its segments at X_W, `dt_s` after the picture before; those that
  /// fewer than two cameras see, or that are lost, are NaN in all three places. Real-time safe.
  /// @pre p_W.size() == kArmMarkers
  void look(const ArmBody& body, const ArmPoses& X_W, double dt_s, std::span<Vec3> p_W) noexcept;

 private:
  ArmTraits traits_;
  Random skin_random_, camera_random_, loss_random_;
  std::array<Vec3, kArmMarkers> skin_;        ///< on the bone [m]
  std::array<double, kArmMarkers> lost_s_{};  ///< still lost for this long
  double blocked_s_ = 0.0;                    ///< the same of all but the brace
};

}  // namespace isograsp::virtual_patient
