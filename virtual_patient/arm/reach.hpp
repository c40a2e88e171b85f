// SPDX-License-Identifier: GPL-3.0-or-later
// Which posture brings the object to a pose: of all that do, the one that is nearest to the start
// posture in the eyes of this person. What can turn about an axis shares a turn in proportion to
// its compliance.
#pragma once

#include "virtual_patient/arm/arm_body.hpp"
#include "virtual_patient/arm/arm_traits.hpp"

namespace isograsp::virtual_patient {

class Reach {
 public:
  /// @pre body outlives this
  Reach(const ArmTraits& traits, const ArmBody& body) noexcept;

  /// The posture for the object at X_WO; where ranges end before, the nearest that is found.
  /// Real-time safe.
  [[nodiscard]] Joints posture_for(const Pose& X_WO) const noexcept;

 private:
  /// What is left to the object at X_BO, lengths scaled.
  [[nodiscard]] Vec6 error_at(const Joints& q, const Pose& X_BO) const noexcept;
  /// One step of Gauss-Newton.
  [[nodiscard]] Joints improved(const Joints& q, const Pose& X_BO) const noexcept;

  const ArmBody& body_;
  Joints compliance_;
};

}  // namespace isograsp::virtual_patient
