// SPDX-License-Identifier: GPL-3.0-or-later
// What ties an object to a fingertip, or to a point that is led: spring and damper between two
// points, and about the normal of the contact; implicit in the step. SI units. Real-time safe.
#pragma once

#include "core/spatial.hpp"
#include "hand_world/hand_body.hpp"
#include "hand_world/rigid_object.hpp"
#include "virtual_hand/assistance.hpp"

namespace isograsp::hand_world {

/// Where a fingertip touches the object, in both of their frames.
struct TouchPoint {
  std::size_t link = kLinkCount - 1;
  Vec3 p_F = Vec3::Zero();  ///< link frame F: origin where the link begins
  Vec3 p_O = Vec3::Zero();
  Vec3 normal_O = Vec3::UnitZ();  ///< into the object
  Quat q_OF = Quat::Identity();   ///< attitude of the link
};

/// Of one step: what the spring does, and how it depends on the velocities.
class Tie {
 public:
  /// To a digit.
  Tie(int digit, const TouchPoint& at, const virtual_hand::TieGains& gains) noexcept
      : digit_(digit), at_(at), gains_(gains) {}
  /// To a point that is led: lead() says where it is.
  Tie(const Vec3& p_O, double stiffness_N_m, double damping_N_s_m) noexcept;

  [[nodiscard]] int digit() const noexcept { return digit_; }
  /// The far end in the middle of the coming step.
  void lead(const Vec3& p_W, const Vec3& v_W) noexcept {
    led_p_W_ = p_W;
    led_v_W_ = v_W;
  }
  /// Adds it to matrix and pull. `hand`: null for a point that is led. `X_WO`: in the middle of the
  /// step; `now`: velocities at its begin.
  void add_to(Arrow& matrix, ArrowVector& pull, const HandBody* hand, const Pose& X_WO,
              const ArrowVector& now, double step_s) noexcept;
  /// After the step: `change` of the velocities in its middle against those at its begin.
  void settle(const ArrowVector& change, double step_s) noexcept;
  /// Effort of the spring in the middle of the last step, whichever way it points [N].
  [[nodiscard]] double effort_N() const noexcept { return effort_N_; }
  [[nodiscard]] const TouchPoint& at() const noexcept { return at_; }
  static constexpr int kLed = -1;

 private:
  using PointRows = Eigen::Matrix<double, 3, kHubSize>;
  [[nodiscard]] Vec3 change_of(const ArrowVector& velocity) const noexcept;

  int digit_ = kLed;
  TouchPoint at_;
  virtual_hand::TieGains gains_;
  Vec3 led_p_W_ = Vec3::Zero();
  Vec3 led_v_W_ = Vec3::Zero();
  PointRows hub_ = PointRows::Zero();  ///< velocity of the far end against the object
  Eigen::Matrix<double, 3, kLeafSize> leaf_ = Eigen::Matrix<double, 3, kLeafSize>::Zero();
  Vec3 force_W_ = Vec3::Zero();  ///< on the object
  double effort_N_ = 0.0;
};

}  // namespace isograsp::hand_world
