// SPDX-License-Identifier: GPL-3.0-or-later
// I w' = tau - C w - spring(q) - w x I w,  q' = q (0, w) / 2, w in body axes.
#include "grasp_model/spin.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/angle_ratio.hpp"
#include "grasp_model/rotation.hpp"

namespace isograsp::so3 {

SpinVector pack(const Spin& spin) noexcept {
  SpinVector y;
  y << spin.q_WO.w(), spin.q_WO.vec(), spin.w_O, 0.0;
  return y;
}

Spin unpack(const SpinVector& y) noexcept {
  return {Quat(y[0], y[1], y[2], y[3]), y.segment<3>(4)};
}

SpinRate::SpinRate(const Body& body) noexcept
    : body_(body),
      massless_(body.inertia_kg_m2.minCoeff() == 0.0),
      spring_(!body.stiffness.isZero(0.0)),
      even_spring_(body.stiffness.x() == body.stiffness.y() &&
                   body.stiffness.y() == body.stiffness.z()) {
  double spring = 0.0;
  double damper = 0.0;
  double massless = 0.0;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double I = body.inertia_kg_m2[i];
    if (I == 0.0) {
      massless = std::max(massless, body.stiffness[i] / body.damping[i]);
    } else {
      inverse_inertia_[i] = 1.0 / I;
      spring = std::max(spring, body.stiffness[i] / I);
      damper = std::max(damper, body.damping[i] / I);
    }
  }
  own_rate_ = std::sqrt(spring) + damper + massless;
  overdamped_ = damper + massless >= 2.0 * std::sqrt(spring);
}

void SpinRate::load(const Torques& torques) noexcept {
  torques_ = torques;
  world_ = !torques.world.isZero(0.0);
}

double SpinRate::resisting(double hold_s) const noexcept {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double I = body_.inertia_kg_m2[i];
    const double C = body_.damping[i];
    least = std::min(least, I == 0.0 ? C : std::max(I / hold_s, C));
  }
  return least;
}

double SpinRate::fastest(const SpinVector& y, double hold_s) const noexcept {
  const double torque = torques_.world.norm() + torques_.body.norm();
  return y.segment<3>(4).norm() + torque / resisting(hold_s) + own_rate_;
}

Vec3 SpinRate::held(const SpinVector& y) const noexcept {
  Vec3 torque = torques_.body;
  if (world_) {  // R^T tau = tau - w t + v x t, t = 2 v x tau, for a unit quaternion
    const Vec3 v = y.segment<3>(1);
    const Vec3 t = 2.0 * v.cross(torques_.world);
    torque += (torques_.world - y[0] * t) + v.cross(t);
  }
  return torque;
}

Vec3 SpinRate::drive(const SpinVector& y) const noexcept {
  Vec3 torque = held(y);
  if (spring_) {
    const Vec3 v = y.segment<3>(1);
    const double ratio = angle_ratio((v.x() * v.x() + v.y() * v.y()) + v.z() * v.z(), y[0]);
    if (even_spring_)
      torque -= (body_.stiffness.x() * ratio) * v;
    else
      torque += spring_torque(ratio * v, body_.stiffness);
  }
  return torque;
}

double SpinRate::power(const SpinVector& y) const noexcept {
  return held(y).dot(y.segment<3>(4));
}

double SpinRate::energy(const SpinVector& y) const noexcept {
  const Vec3 w_O = y.segment<3>(4);
  double twice_J = w_O.dot(body_.inertia_kg_m2.cwiseProduct(w_O));
  if (spring_) {
    const Vec3 v = y.segment<3>(1);
    const Vec3 phi = angle_ratio(v.squaredNorm(), y[0]) * v;
    twice_J += phi.dot(body_.stiffness.cwiseProduct(phi));
  }
  return 0.5 * twice_J;
}

double SpinRate::limit_energy(double most_J, SpinVector& y) const noexcept {
  const double all_J = energy(y);
  if (all_J <= most_J) return 0.0;
  const Vec3 w_O = y.segment<3>(4);
  const double moving_J = 0.5 * w_O.dot(body_.inertia_kg_m2.cwiseProduct(w_O));
  const double spring_J = all_J - moving_J;
  if (spring_J <= most_J) {
    y.segment<3>(4) *= std::sqrt(std::max(0.0, most_J - spring_J) / moving_J);
    return 0.0;
  }
  // The energy of the spring is a quadratic form of the rotation vector.
  const Vec3 phi = log(Quat(y[0], y[1], y[2], y[3]));
  const double kept = std::sqrt(std::max(0.0, most_J) / spring_J);
  y = pack({exp(kept * phi), Vec3::Zero()});
  return (1.0 - kept) * phi.norm();
}

Vec3 SpinRate::settled(const Vec3& driving, Vec3 w_O) const noexcept {
  const Vec3& I = body_.inertia_kg_m2;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (I[i] != 0.0) continue;
    const Eigen::Index j = (i + 1) % 3;
    const Eigen::Index k = (i + 2) % 3;
    // (w x I w)_i; for a massless body it is 0, so the order of the axes does not matter.
    w_O[i] = (driving[i] - (I[k] - I[j]) * w_O[j] * w_O[k]) / body_.damping[i];
  }
  return w_O;
}

void SpinRate::settle(SpinVector& y) const noexcept {
  if (massless_) y.segment<3>(4) = settled(drive(y), y.segment<3>(4));
}

bool SpinRate::too_fast(const SpinVector& y, double step_s, double hold_s) const noexcept {
  constexpr double kFollowed_rad = 2.0;  // a step
  constexpr double kGone = 25.0;         // exp(-25) = 1e-11
  if (y.segment<3>(4).norm() * step_s > kFollowed_rad) return true;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double decay = 0.5 * body_.damping[i] * inverse_inertia_[i];
    const double swing = body_.stiffness[i] * inverse_inertia_[i] - decay * decay;
    if (swing > 0.0 && std::sqrt(swing) * step_s > kFollowed_rad && decay * hold_s < kGone)
      return true;
  }
  return false;
}

}  // namespace isograsp::so3
