// SPDX-License-Identifier: GPL-3.0-or-later
// When two hands hold an object between them: both squeeze along their line, and the line goes
// through enough of the object with either hand near it (docs/bimanual.md, "Holding"). Pure.
#pragma once

#include <array>

#include "bimanual/hands_spec.hpp"
#include "grasp_model/scene.hpp"

namespace isograsp::bimanual {

class GraspOfHands {
 public:
  GraspOfHands(const GraspDetection& rule, Shape shape, const Vec3& size_m) noexcept
      : rule_(rule), shape_(shape), size_m_(size_m) {}

  /// One row: hands and their pushes in world axes, the object where it is. Real-time safe.
  bool see(const std::array<Vec3, kSides>& p_W, const std::array<Vec3, kSides>& push_W_N,
           const Pose& X_WO) noexcept;

  /// It is in no hand, whatever they squeeze.
  void let_go() noexcept { holds_ = false; }

  [[nodiscard]] bool holds() const noexcept { return holds_; }
  /// Push of each hand towards the other [N]; below 0: away from it.
  [[nodiscard]] const std::array<double, kSides>& squeeze_N() const noexcept { return squeeze_N_; }
  /// Where the line of the hands entered and left the object when it was taken, object axes.
  [[nodiscard]] const std::array<Vec3, kSides>& anchors_O() const noexcept { return anchor_O_; }

 private:
  GraspDetection rule_;
  Shape shape_;
  Vec3 size_m_;
  bool holds_ = false;
  double chord_m_ = 0.0;  ///< when it was taken
  std::array<double, kSides> squeeze_N_{};
  std::array<Vec3, kSides> anchor_O_{Vec3::Zero(), Vec3::Zero()};
};

}  // namespace isograsp::bimanual
