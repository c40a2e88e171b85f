// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/carried_object.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/dormand_prince.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp::bimanual {

namespace {

/// Position, attitude, velocity, turning.
using HangState = Eigen::Matrix<double, 13, 1>;

/// An object on a spring and a damper from either hand, beside those of the scene.
class Hanging {
 public:
  Hanging(const Scene& scene, const Magnet& magnet, const std::array<Vec3, kSides>& p_W,
          const std::array<Vec3, kSides>& anchor_O) noexcept
      : scene_(scene), magnet_(magnet), p_W_(p_W), anchor_O_(anchor_O) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      moves_[axis] = scene.free[i] ? 1.0 : 0.0;
      turns_[axis] = scene.free[i + 3] ? 1.0 : 0.0;
    }
  }

  [[nodiscard]] HangState rate(const HangState& y) const noexcept {
    const Vec3 p = y.head<3>(), v = y.segment<3>(7), w = y.tail<3>();
    const Quat q(y[3], y[4], y[5], y[6]);
    const Mat3 R = q.normalized().toRotationMatrix();
    Vec3 force = scene_.mass_kg * scene_.gravity_m_s2 -
                 scene_.R_WK * scene_.stiffness.head<3>().asDiagonal() * scene_.R_WK.transpose() *
                     (p - scene_.anchor_m) -
                 scene_.R_WD * scene_.damping.head<3>().asDiagonal() * scene_.R_WD.transpose() * v;
    const Vec3 w_O = R.transpose() * w;
    Vec3 torque_O = -scene_.damping.tail<3>().cwiseProduct(w_O);
    if (!scene_.stiffness.tail<3>().isZero()) {
      const Eigen::AngleAxisd turned(q.normalized());
      torque_O -= scene_.stiffness.tail<3>().cwiseProduct(turned.angle() * turned.axis());
    }
    for (std::size_t side = 0; side < kSides; ++side) {
      const Vec3 arm = R * anchor_O_[side];
      const Vec3 pull = magnet_.stiffness_N_m * (p_W_[side] - p - arm) -
                        magnet_.damping_N_s_m * (v + w.cross(arm));
      force += pull;
      torque_O += R.transpose() * arm.cross(pull);
    }
    HangState dy;
    dy.head<3>() = moves_.cwiseProduct(v);
    const Quat spin(0.0, w.x(), w.y(), w.z());
    dy.segment<4>(3) << 0.5 * (spin * q).w(), 0.5 * (spin * q).vec();
    dy.segment<3>(7) = moves_.cwiseProduct(force) / scene_.mass_kg;
    const Vec3 momentum = scene_.inertia_kg_m2.cwiseProduct(w_O);
    Vec3 dw_O = Vec3::Zero();
    for (Eigen::Index i = 0; i < 3; ++i)
      if (turns_[i] > 0.0) dw_O[i] = (torque_O - w_O.cross(momentum))[i] / scene_.inertia_kg_m2[i];
    dy.tail<3>() = R * dw_O;
    return dy;
  }

 private:
  const Scene& scene_;
  const Magnet& magnet_;
  const std::array<Vec3, kSides>& p_W_;
  const std::array<Vec3, kSides>& anchor_O_;
  Vec3 moves_, turns_;
};

HangState packed(const ObjectState& state) noexcept {
  HangState y;
  const Quat& q = state.X_WO.q;
  y << state.X_WO.p, q.w(), q.x(), q.y(), q.z(), state.v_WO_W, state.w_WO_W;
  return y;
}

}  // namespace

CarriedObject::CarriedObject(const Plan& plan, const Magnet& magnet) noexcept
    : plan_(plan), magnet_(magnet), state_(plan.initial_state()) {}

void CarriedObject::move(const std::array<Vec3, kSides>& p_W, const GraspOfHands& grasp,
                         double hold_s) {
  const bool holds = grasp.holds() && magnet_.mode != Magnet::Mode::off;
  if (holds && !held_) {
    taken_X_WO_ = state_.X_WO;
    taken_middle_W_ = 0.5 * (p_W[0] + p_W[1]);
    taken_line_W_ = p_W[1] - p_W[0];
  }
  // Nobody throws: what is let go stands still.
  if (!holds && held_ && magnet_.mode == Magnet::Mode::constraint)
    state_ = plan_.at_rest(state_.X_WO);
  held_ = holds;
  if (!holds)
    plan_.move(GraspWrench{}, hold_s, state_);
  else if (magnet_.mode == Magnet::Mode::constraint)
    follow(p_W, hold_s);
  else
    hang(p_W, grasp.anchors_O(), hold_s);
}

Quat CarriedObject::turn_of(const Vec3& line_W) const noexcept {
  const auto& free = plan_.scene().free;
  const bool x = free[3], y = free[4], z = free[5];
  if (x && y && z) return so3::shortest(taken_line_W_, line_W);
  if (!z || x || y) return Quat::Identity();
  const double angle_rad =
      std::atan2(line_W.y(), line_W.x()) - std::atan2(taken_line_W_.y(), taken_line_W_.x());
  return Quat(Eigen::AngleAxisd(angle_rad, Vec3::UnitZ()));
}

void CarriedObject::follow(const std::array<Vec3, kSides>& p_W, double hold_s) noexcept {
  const Scene& scene = plan_.scene();
  const Quat turn = turn_of(p_W[1] - p_W[0]);
  Pose X_WO;
  X_WO.q = turn * taken_X_WO_.q;
  X_WO.p = 0.5 * (p_W[0] + p_W[1]) + turn * (taken_X_WO_.p - taken_middle_W_);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (!scene.free[i]) X_WO.p[axis] = state_.X_WO.p[axis];
  }
  for (const TravelLimit& limit : scene.limits)
    if (limit.dof <= Dof::z) {
      double& place_m = X_WO.p[static_cast<Eigen::Index>(limit.dof)];
      place_m = std::clamp(place_m, limit.least, limit.most);
    }
  const Pose before = state_.X_WO;
  if (X_WO.q.dot(before.q) < 0.0) X_WO.q.coeffs() *= -1.0;
  const Eigen::AngleAxisd turned(X_WO.q * before.q.conjugate());
  state_ = plan_.at_rest(X_WO);
  state_.v_WO_W = (X_WO.p - before.p) / hold_s;
  state_.w_WO_W = turned.angle() / hold_s * turned.axis();
}

void CarriedObject::hang(const std::array<Vec3, kSides>& p_W,
                         const std::array<Vec3, kSides>& anchor_O, double hold_s) {
  // The error that a hold may have, of places [m] and attitudes: far below what is drawn.
  constexpr double kTolerance = 1e-12;
  constexpr double kLeastShare = 1e-6;  // of a hold: stiffer springs are not resolved
  const Hanging hanging(plan_.scene(), magnet_, p_W, anchor_O);
  HangState y = packed(state_);
  std::array<HangState, 12> k;
  double done_s = 0.0, step_s = hold_s;
  while (done_s < hold_s) {
    step_s = std::min(step_s, hold_s - done_s);
    dormand_prince::stages(
        y, step_s, [&](std::size_t, const HangState& at) { return hanging.rate(at); }, k);
    const double error =
        step_s * dormand_prince::error5(k).head<7>().cwiseAbs().maxCoeff() / kTolerance;
    if (error > 1.0 && step_s > kLeastShare * hold_s) {
      step_s *= std::max(0.2, 0.9 * std::pow(error, -1.0 / 6.0));
      continue;
    }
    y += step_s * dormand_prince::increment(k);
    done_s = hold_s - done_s - step_s > 1e-15 * hold_s ? done_s + step_s : hold_s;
    step_s *= std::clamp(0.9 * std::pow(std::max(error, 1e-12), -1.0 / 6.0), 0.5, 5.0);
  }
  ObjectState next = plan_.at_rest({y.head<3>(), Quat(y[3], y[4], y[5], y[6]).normalized()});
  next.v_WO_W = y.segment<3>(7);
  next.w_WO_W = y.tail<3>();
  state_ = next;
}

}  // namespace isograsp::bimanual
