// SPDX-License-Identifier: GPL-3.0-or-later
// Gauss-Newton for   min (q - q0)^T C^-1 (q - q0)   so that   object(q) = goal,
// e the error of the object at q (6 rows, lengths / 0.2 m), J = d object / dq:
//   q <- q0 + C J^T (J C J^T + r I)^-1 (e + J (q - q0))
// A joint that would leave its range is put to the end of it and takes part as a constant.
#include "virtual_patient/arm/reach.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "grasp_model/rotation.hpp"
#include "kinematics/attitude.hpp"

namespace isograsp::virtual_patient {

namespace {

constexpr double kLength_m = 0.2;  ///< of an error that counts as one radian
constexpr int kSteps = 16;
constexpr int kParts = 6;
constexpr int kHalves = 3;
constexpr int kPasses = kJoints - 5;  ///< with fewer than six joints left nothing can be chosen
/// Keeps the equations solvable where ranges leave fewer than six ways to move: 0.1 % of a joint
/// that is free to turn.
constexpr double kRidge = 1e-3 * 0.3;
constexpr double kSettled = 1e-9;
constexpr double kSwingShare = 0.15;    ///< of the forearm about the elbow, in a brace
constexpr double kTiltShare = 0.5;      ///< fingers tilt an object less easily than they twirl it
constexpr double kReachShift_m = 0.03;  ///< shift of the object in the fingers, as easy as 1 rad
constexpr double kLean_m = 0.15;        ///< … and of the elbow with the trunk

}  // namespace

Reach::Reach(const ArmTraits& traits, const ArmBody& body) noexcept : body_(body) {
  compliance_[joint::pronation] = traits.forearm_share;
  compliance_[joint::swing_up] = compliance_[joint::swing_in] = kSwingShare * traits.forearm_share;
  compliance_[joint::flexion] = compliance_[joint::ulnar] = traits.wrist_share;
  compliance_[joint::turn_z] = traits.finger_share;
  compliance_[joint::turn_x] = compliance_[joint::turn_y] = kTiltShare * traits.finger_share;
  for (const auto k : {joint::shift_x, joint::shift_y, joint::shift_z})
    compliance_[k] = kReachShift_m * kReachShift_m * traits.finger_share;
  compliance_[joint::lift] = traits.shoulder_share;
  for (const auto k : {joint::lean_x, joint::lean_y, joint::lean_z})
    compliance_[k] = kLean_m * kLean_m * traits.trunk_share;
}

Joints Reach::posture_for(const Pose& X_WO) const noexcept {
  const Pose goal = compose(inverse(body_.X_WB), X_WO);
  const Pose from = body_.poses_B(body_.rest)[index_of(Segment::object)];
  const Vec3 turn = rotation_vector(goal.q * from.q.conjugate());
  Joints q = body_.rest;
  for (int step = 1; step <= kSteps; ++step) {
    // The way there in parts, so that the equations are nearly linear.
    const double part = std::min(1.0, static_cast<double>(step) / kParts);
    const Pose X_BO{from.p + part * (goal.p - from.p), so3::exp(part * turn) * from.q};
    Joints next = improved(q, X_BO);
    // Far from linear, a whole step leads astray.
    const double before = error_at(q, X_BO).norm();
    for (int half = 0; half < kHalves && error_at(next, X_BO).norm() > before; ++half)
      next = 0.5 * (q + next);
    const bool settled = step > kParts && (next - q).cwiseAbs().maxCoeff() < kSettled;
    q = next;
    if (settled) break;
  }
  return q;
}

Vec6 Reach::error_at(const Joints& q, const Pose& X_BO) const noexcept {
  const Pose X_now = body_.poses_B(q)[index_of(Segment::object)];
  Vec6 error;
  error << (X_BO.p - X_now.p) / kLength_m, rotation_vector(X_BO.q * X_now.q.conjugate());
  return error;
}

Joints Reach::improved(const Joints& q, const Pose& X_BO) const noexcept {
  ArmJacobian J = body_.jacobian_B(q);
  J.topRows<3>() /= kLength_m;
  const Vec6 needed = error_at(q, X_BO) + J * (q - body_.rest);
  Joints compliance = compliance_;
  Joints ended = Joints::Zero();  // ways of joints that are at an end
  Joints within = q;
  for (int pass = 0; pass < kPasses; ++pass) {
    const ArmJacobian weighted = J * compliance.asDiagonal();
    Eigen::Matrix<double, 6, 6> square = weighted * J.transpose();
    square.diagonal().array() += kRidge;
    const Joints next =
        body_.rest + ended + weighted.transpose() * square.ldlt().solve(needed - J * ended);
    within = next.cwiseMax(body_.least).cwiseMin(body_.most);
    // The one that goes furthest beyond its end, for what it costs.
    int worst = -1;
    double most = 0.0;
    for (int k = 0; k < kJoints; ++k) {
      const double beyond = std::abs(within[k] - next[k]) / std::sqrt(compliance_[k]);
      if (!(beyond > most) || compliance[k] == 0.0) continue;
      most = beyond;
      worst = k;
    }
    if (worst < 0) break;
    ended[worst] = within[worst] - body_.rest[worst];
    compliance[worst] = 0.0;
  }
  return within;
}

}  // namespace isograsp::virtual_patient
