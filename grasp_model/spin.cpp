// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/spin.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/rotation.hpp"

namespace isograsp::so3 {

namespace {

/// atan(sqrt(u)) / sqrt(u) on 0 <= u <= tan^2(22.5 deg): interpolated at the Chebyshev points of
/// [0, 0.18], relative error 2e-18.
constexpr std::array<double, 12> kAtan{
    0.99999999999999999785,   -0.33333333333332988423,  0.19999999999908397494,
    -0.14285714276163336721,  0.11111110595175503333,   -0.090908925875751227634,
    0.076919713876241141661,  -0.066621225134109813804, 0.058409193896630637071,
    -0.050085783940660889834, 0.03729948684921499417,   -0.017085141492542090346};
constexpr double kAtanReach = 0.17157287525380990;  // tan^2(22.5 deg)

double atan_ratio(double u) noexcept {
  const auto& a = kAtan;
  const double u2 = u * u;
  const double u4 = u2 * u2;
  const double low = (a[0] + a[1] * u) + u2 * (a[2] + a[3] * u);
  const double middle = (a[4] + a[5] * u) + u2 * (a[6] + a[7] * u);
  const double high = (a[8] + a[9] * u) + u2 * (a[10] + a[11] * u);
  return low + u4 * (middle + u4 * high);
}

/// phi / v for q = (w, v), |v|^2 = s2: no transcendental function up to 90 degrees.
double angle_ratio(double s2, double w) noexcept {
  if (w > 0.0) {
    if (s2 <= kAtanReach * (w * w)) {
      const double inverse = 1.0 / w;
      return 2.0 * inverse * atan_ratio(s2 * inverse * inverse);
    }
    const double inverse = 1.0 / (w + std::sqrt(s2 + w * w));  // of the half angle
    const double u = s2 * inverse * inverse;
    if (u <= kAtanReach) return 4.0 * inverse * atan_ratio(u);
  }
  const double s = std::sqrt(s2);
  return s == 0.0 ? 2.0 / w : 2.0 * std::atan2(s, w) / s;
}

}  // namespace

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

double SpinRate::fastest(const SpinVector& y, double hold_s) const noexcept {
  const double torque = torques_.world.norm() + torques_.body.norm();
  double gained = 0.0;  // speed
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double I = body_.inertia_kg_m2[i];
    gained = std::max(gained, I == 0.0 ? torque / body_.damping[i]
                                       : torque / std::max(I / hold_s, body_.damping[i]));
  }
  return y.segment<3>(4).norm() + gained + own_rate_;
}

Vec3 SpinRate::drive(const SpinVector& y) const noexcept {
  Vec3 torque = torques_.body;
  const Vec3 v = y.segment<3>(1);
  const double w = y[0];
  if (world_) {  // R^T tau = tau - 2 v x (w tau - v x tau) for a unit quaternion
    const Vec3 t = 2.0 * v.cross(torques_.world);
    torque += torques_.world - w * t + v.cross(t);
  }
  if (spring_) {
    if (even_spring_)
      torque -= (body_.stiffness.x() * angle_ratio(v.squaredNorm(), w)) * v;
    else
      torque += spring_torque(angle_ratio(v.squaredNorm(), w) * v, body_.stiffness);
  }
  return torque;
}

SpinVector SpinRate::operator()(const SpinVector& y) const noexcept {
  Vec3 torque = drive(y);
  const Vec3& I = body_.inertia_kg_m2;
  Vec3 w_O = y.segment<3>(4);
  if (massless_) w_O = settled(torque, w_O);
  torque -= body_.damping.cwiseProduct(w_O);
  torque.x() -= (I.z() - I.y()) * w_O.y() * w_O.z();
  torque.y() -= (I.x() - I.z()) * w_O.z() * w_O.x();
  torque.z() -= (I.y() - I.x()) * w_O.x() * w_O.y();
  SpinVector rate;
  const double w = y[0];
  const Vec3 v = y.segment<3>(1);
  rate[0] = -0.5 * v.dot(w_O);
  rate.segment<3>(1) = 0.5 * (w * w_O + v.cross(w_O));
  rate.segment<3>(4) = inverse_inertia_.cwiseProduct(torque);
  rate[7] = 0.0;
  return rate;
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
