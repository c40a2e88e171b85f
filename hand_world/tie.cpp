// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/tie.hpp"

#include "grasp_model/rotation.hpp"

namespace isograsp::hand_world {

namespace {

/// Rotation vector of length at most pi.
Vec3 turn_between(const Quat& from, const Quat& to) noexcept {
  Quat turn = to * from.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  return so3::log(turn);
}

}  // namespace

Tie::Tie(const Vec3& p_O, double stiffness_N_m, double damping_N_s_m) noexcept {
  at_.p_O = p_O;
  gains_.stiffness_N_m = stiffness_N_m;
  gains_.damping_N_s_m = damping_N_s_m;
}

Vec3 Tie::change_of(const ArrowVector& velocity) const noexcept {
  Vec3 change = hub_ * velocity.hub;
  if (digit_ != kLed) change += leaf_ * velocity.leaves[static_cast<std::size_t>(digit_)];
  return change;
}

void Tie::add_to(Arrow& matrix, ArrowVector& pull, const HandBody* hand, const Pose& X_WO,
                 const ArrowVector& now, double step_s) noexcept {
  const Mat3 R_WO = X_WO.q.toRotationMatrix();
  const Vec3 arm_W = R_WO * at_.p_O;
  const Vec3 at_object_W = X_WO.p + arm_W;
  const Vec3 normal_W = R_WO * at_.normal_O;
  hub_.setZero();
  leaf_.setZero();
  hub_.block<3, 3>(0, kObjectPart) = -Mat3::Identity();
  hub_.block<3, 3>(0, kObjectPart + 3) = skew(arm_W) * R_WO;
  Vec3 far_W = led_p_W_;
  Vec3 led_v_W = led_v_W_;
  HandBody::PointRows rows;
  const auto d = static_cast<std::size_t>(digit_ == kLed ? 0 : digit_);
  if (digit_ != kLed) {
    const virtual_hand::DigitPose& digit = hand->middle().digits[d];
    far_W = digit.joints[at_.link] + digit.links[at_.link] * at_.p_F;
    led_v_W.setZero();
    rows = hand->rows_of(digit_, at_.link, far_W);
    hub_.block<3, 6>(0, kPalmPart) = rows.palm;
    leaf_ = rows.rates;
  }
  const double k = gains_.stiffness_N_m;
  const double c = gains_.damping_N_s_m;
  force_W_ = k * (far_W - at_object_W) + c * (change_of(now) + led_v_W);
  pull.hub -= hub_.transpose() * force_W_;
  const double weight = 0.5 * step_s * c + 0.25 * step_s * step_s * k;
  matrix.hub += weight * (hub_.transpose() * hub_);
  if (digit_ == kLed) return;
  pull.leaves[d] -= leaf_.transpose() * force_W_;
  matrix.edges[d] += weight * (hub_.transpose() * leaf_);
  matrix.leaves[d] += weight * (leaf_.transpose() * leaf_);

  // About the normal: a spring, and a damper in the same proportion.
  if (!(k > 0.0)) return;
  const double turning_k = gains_.torsion_N_m_rad;
  const double turning_c = c * turning_k / k;
  HubVector hub_row = HubVector::Zero();  // rate of the link against the object
  hub_row.segment<3>(kPalmPart + 3) = normal_W;
  hub_row.segment<3>(kObjectPart + 3) = -(R_WO.transpose() * normal_W);
  const LeafVector leaf_row = rows.axes.transpose() * normal_W;
  const Quat& link = hand->middle().digits[d].links[at_.link];
  const double torque = turning_k * normal_W.dot(turn_between(X_WO.q * at_.q_OF, link)) +
                        turning_c * (hub_row.dot(now.hub) + leaf_row.dot(now.leaves[d]));
  pull.hub -= torque * hub_row;
  pull.leaves[d] -= torque * leaf_row;
  const double turning = 0.5 * step_s * turning_c + 0.25 * step_s * step_s * turning_k;
  matrix.hub += turning * (hub_row * hub_row.transpose());
  matrix.edges[d] += turning * (hub_row * leaf_row.transpose());
  matrix.leaves[d] += turning * (leaf_row * leaf_row.transpose());
}

void Tie::settle(const ArrowVector& change, double step_s) noexcept {
  const Vec3 force_W =
      force_W_ + (gains_.damping_N_s_m + 0.5 * step_s * gains_.stiffness_N_m) * change_of(change);
  effort_N_ = force_W.norm();
}

}  // namespace isograsp::hand_world
