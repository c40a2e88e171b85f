// SPDX-License-Identifier: GPL-3.0-or-later
// The object between two hands: free, on springs from both hands, or led by their line (Talvas et
// al., magnetic pinch; docs/bimanual.md, "Carrying"). SI units, world axes. No allocation.
#pragma once

#include <array>

#include "bimanual/grasp_of_hands.hpp"
#include "bimanual/hands_spec.hpp"
#include "grasp_model/plan.hpp"

namespace isograsp::bimanual {

class CarriedObject {
 public:
  /// Refers to `plan`, which must outlive it.
  CarriedObject(const Plan& plan, const Magnet& magnet) noexcept;

  [[nodiscard]] const ObjectState& state() const noexcept { return state_; }

  /// It stands here, at rest, in no hand. Real-time safe.
  void put(const Pose& X_WO) noexcept {
    state_ = plan_.at_rest(X_WO);
    held_ = false;
  }

  /// From one row to the next: hands and grasp as they are in the first of them.
  void move(const std::array<Vec3, kSides>& p_W, const GraspOfHands& grasp, double hold_s);

 private:
  void follow(const std::array<Vec3, kSides>& p_W, double hold_s) noexcept;
  void hang(const std::array<Vec3, kSides>& p_W, const std::array<Vec3, kSides>& anchor_O,
            double hold_s);
  [[nodiscard]] Quat turn_of(const Vec3& line_W) const noexcept;

  const Plan& plan_;
  Magnet magnet_;
  ObjectState state_;
  bool held_ = false;
  Pose taken_X_WO_;      ///< when it was taken
  Vec3 taken_middle_W_;  ///< of the hands
  Vec3 taken_line_W_;
};

}  // namespace isograsp::bimanual
