// SPDX-License-Identifier: GPL-3.0-or-later
//   E  elbow_B + lean + lift L (0.5, 0.8, 0)          attitude Rz(lift)
//   F  origin E, attitude Rz(lift) Rx(up) Ry(in) Rz(pronation)
//   H  origin at the wrist F (0, 0, -l), attitude F Ry(flexion) Rx(-ulnar)
//   O  X_H X_HO with shift and turn: p + shift, exp(turn) q
// As angles of a rig (EF rpy, FD zxy): pronation is yaw, flexion is a1, ulnar deviation a2.
#include "virtual_patient/arm/arm_body.hpp"

#include <numbers>

#include "grasp_model/rotation.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp::virtual_patient {

namespace {

/// The shoulder raises the elbow outwards and up.
const Vec3 kLifted{0.5, 0.8, 0.0};

/// Axes of the dorsum in those of the hand: a half turn about (0, 1, 1).
const Quat kDorsumAxes(0.0, 0.0, std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0);

Quat turned(const Vec3& axis, double angle_rad) noexcept {
  return so3::exp(angle_rad * axis);
}

/// The object of the rig of Kurillo et al. (15 markers).
const std::array<Vec3, 6> kObjectTemplate{Vec3(0.03, 0.02, 0.04),   Vec3(-0.03, 0.02, 0.04),
                                          Vec3(0.03, -0.02, 0.04),  Vec3(-0.03, 0.02, -0.04),
                                          Vec3(0.03, -0.02, -0.04), Vec3(-0.03, -0.02, -0.035)};

}  // namespace

ArmBody::ArmBody(const ArmTraits& traits, Random& random, Hand hand) noexcept
    : X_WB{Vec3(-0.05, -0.05, 0.35), Quat::Identity()},
      elbow_B(0.05, 0.05, -0.02),
      breastbone_B(-0.2, 0.3, 0.1),
      forearm_m(traits.forearm_m),
      upper_arm_m(traits.upper_arm_m),
      X_HO{Vec3(-0.03, 0.008, -traits.reach_m), kDorsumAxes} {
  constexpr double kBand_m = 0.03;  // markers of the forearm: this far from the wrist
  const Vec3 up = Vec3::UnitY();
  const Vec3 back = Vec3::UnitX();  // of the hand
  const double band = -(traits.forearm_m - kBand_m);
  markers = {ArmMarker{"B1", Segment::brace, Vec3(0.0, 0.0, 0.0), up, false},
             {"B2", Segment::brace, Vec3(0.08, 0.0, 0.0), up, false},
             {"B3", Segment::brace, Vec3(0.01, 0.06, 0.0), up, false},
             {"EL", Segment::elbow, Vec3(0.0, 0.0, 0.01), Vec3(0.6, 0.6, 0.5), true},
             {"F1", Segment::forearm, Vec3(0.012, 0.028, band), Vec3(1.0, 0.25, 0.0), true},
             {"F2", Segment::forearm, Vec3(0.012, -0.028, band), Vec3(1.0, -0.25, 0.0), true},
             {"W", Segment::forearm, Vec3(0.012, 0.0, -traits.forearm_m), back, true},
             {"D1", Segment::hand, Vec3(0.016, 0.03, -traits.palm_m), back, true},
             {"D2", Segment::hand, Vec3(0.014, -0.03, 0.01 - traits.palm_m), back, true},
             {"O1", Segment::object, kObjectTemplate[0], kObjectTemplate[0], false},
             {"O2", Segment::object, kObjectTemplate[1], kObjectTemplate[1], false},
             {"O3", Segment::object, kObjectTemplate[2], kObjectTemplate[2], false},
             {"O4", Segment::object, kObjectTemplate[3], kObjectTemplate[3], false},
             {"O5", Segment::object, kObjectTemplate[4], kObjectTemplate[4], false},
             {"O6", Segment::object, kObjectTemplate[5], kObjectTemplate[5], false},
             {"T1", Segment::trunk, Vec3::Zero(), Vec3(0.2, 0.6, -0.8), true}};
  for (ArmMarker& marker : markers) {
    if (marker.segment == Segment::object && hand == Hand::left)
      marker.p_S = marker.outward_S = mirrored(marker.p_S);
    marker.outward_S.normalize();
    if (!marker.on_skin) continue;
    for (int axis = 0; axis < 3; ++axis) marker.p_S[axis] += traits.placement_m * random.gaussian();
  }

  rest[joint::pronation] = traits.start_pronation_rad;
  rest[joint::flexion] = -traits.start_extension_rad;
  rest[joint::swing_up] = traits.start_sd_rad * random.gaussian();
  rest[joint::swing_in] = traits.start_sd_rad * random.gaussian();
  rest[joint::ulnar] = traits.start_sd_rad * random.gaussian();
  constexpr double kSwing_rad = 0.4;  // what a brace leaves free
  constexpr double kPressed = 0.3;    // an elbow is pressed to the body less far than it is lifted
  const auto limit = [this](joint::Index k, double below, double above) {
    least[k] = -below;
    most[k] = above;
  };
  limit(joint::pronation, traits.supination_rad, traits.pronation_rad);
  limit(joint::swing_up, kSwing_rad, kSwing_rad);
  limit(joint::swing_in, kSwing_rad, kSwing_rad);
  limit(joint::flexion, traits.extension_rad, traits.flexion_rad);
  limit(joint::ulnar, traits.radial_rad, traits.ulnar_rad);
  for (const auto k : {joint::turn_x, joint::turn_y, joint::turn_z})
    limit(k, traits.finger_turn_rad, traits.finger_turn_rad);
  for (const auto k : {joint::shift_x, joint::shift_y, joint::shift_z})
    limit(k, traits.finger_shift_m, traits.finger_shift_m);
  limit(joint::lift, kPressed * traits.lift_rad, traits.lift_rad);
  for (const auto k : {joint::lean_x, joint::lean_y, joint::lean_z})
    limit(k, traits.lean_m, traits.lean_m);
  rest = rest.cwiseMax(least).cwiseMin(most);
}

ArmPoses ArmBody::poses_B(const Joints& q) const noexcept {
  ArmPoses X_B;
  const Vec3 lean(q[joint::lean_x], q[joint::lean_y], q[joint::lean_z]);
  const auto at = [&X_B](Segment segment) -> Pose& { return X_B[index_of(segment)]; };
  at(Segment::trunk).p = breastbone_B + lean;
  at(Segment::elbow) = {elbow_B + lean + q[joint::lift] * upper_arm_m * kLifted,
                        turned(Vec3::UnitZ(), q[joint::lift])};
  at(Segment::forearm) = {at(Segment::elbow).p, at(Segment::elbow).q *
                                                    turned(Vec3::UnitX(), q[joint::swing_up]) *
                                                    turned(Vec3::UnitY(), q[joint::swing_in]) *
                                                    turned(Vec3::UnitZ(), q[joint::pronation])};
  at(Segment::hand) = compose(at(Segment::forearm), {Vec3(0.0, 0.0, -forearm_m),
                                                     turned(Vec3::UnitY(), q[joint::flexion]) *
                                                         turned(-Vec3::UnitX(), q[joint::ulnar])});
  const Vec3 turn(q[joint::turn_x], q[joint::turn_y], q[joint::turn_z]);
  const Vec3 shift(q[joint::shift_x], q[joint::shift_y], q[joint::shift_z]);
  at(Segment::object) = compose(at(Segment::hand), {X_HO.p + shift, so3::exp(turn) * X_HO.q});
  return X_B;
}

ArmPoses ArmBody::poses_W(const Joints& q) const noexcept {
  ArmPoses X_W = poses_B(q);
  for (Pose& X : X_W) X = compose(X_WB, X);
  return X_W;
}

ArmJacobian ArmBody::jacobian_B(const Joints& q) const noexcept {
  const ArmPoses X_B = poses_B(q);
  const auto at = [&X_B](Segment segment) -> const Pose& { return X_B[index_of(segment)]; };
  const Vec3& p_O = at(Segment::object).p;
  ArmJacobian J = ArmJacobian::Zero();
  const auto turns = [&J, &p_O](int k, const Vec3& axis, const Vec3& origin) {
    J.col(k) << axis.cross(p_O - origin), axis;
  };
  const Vec3& p_E = at(Segment::elbow).p;
  const Quat lifted = at(Segment::elbow).q;
  const Quat raised = lifted * turned(Vec3::UnitX(), q[joint::swing_up]);
  turns(joint::lift, Vec3::UnitZ(), p_E);
  J.col(joint::lift).head<3>() += upper_arm_m * kLifted;
  turns(joint::swing_up, lifted * Vec3::UnitX(), p_E);
  turns(joint::swing_in, raised * Vec3::UnitY(), p_E);
  turns(joint::pronation, at(Segment::forearm).q * Vec3::UnitZ(), p_E);
  const Pose& X_H = at(Segment::hand);
  turns(joint::flexion, at(Segment::forearm).q * Vec3::UnitY(), X_H.p);
  turns(joint::ulnar, X_H.q * -Vec3::UnitX(), X_H.p);
  const Vec3 turn(q[joint::turn_x], q[joint::turn_y], q[joint::turn_z]);
  for (int axis = 0; axis < 3; ++axis) {
    // d exp(turn) = exp(turn) Jr(turn) d, seen from the hand: Jr(-turn) d.
    J.col(joint::turn_x + axis).tail<3>() = X_H.q * so3::jr(-turn, Vec3::Unit(axis));
    J.col(joint::shift_x + axis).head<3>() = X_H.q * Vec3::Unit(axis);
    J.col(joint::lean_x + axis).head<3>() = Vec3::Unit(axis);
  }
  return J;
}

}  // namespace isograsp::virtual_patient
