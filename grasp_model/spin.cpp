// SPDX-License-Identifier: GPL-3.0-or-later
// I w' = tau - C w - spring(q) - w x I w,  q' = q (0, w) / 2, w in body axes.
#include "grasp_model/spin.hpp"

#include <algorithm>
#include <cmath>

#include "grasp_model/dormand_prince.hpp"
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

// Scalars, not vectors, on the way that every stage takes: a vector of three would be read in other
// widths than it was written, which costs more than the arithmetic.
[[gnu::always_inline]] inline void SpinRate::drive(const SpinVector& y, double& tx, double& ty,
                                                   double& tz) const noexcept {
  const double w = y[0];
  const double vx = y[1];
  const double vy = y[2];
  const double vz = y[3];
  tx = torques_.body.x();
  ty = torques_.body.y();
  tz = torques_.body.z();
  if (world_) {  // R^T tau = tau - w t + v x t, t = 2 v x tau, for a unit quaternion
    const Vec3& tau = torques_.world;
    const double sx = 2.0 * (vy * tau.z() - vz * tau.y());
    const double sy = 2.0 * (vz * tau.x() - vx * tau.z());
    const double sz = 2.0 * (vx * tau.y() - vy * tau.x());
    tx += (tau.x() - w * sx) + (vy * sz - vz * sy);
    ty += (tau.y() - w * sy) + (vz * sx - vx * sz);
    tz += (tau.z() - w * sz) + (vx * sy - vy * sx);
  }
  if (spring_) {
    const double ratio = angle_ratio(vx * vx + vy * vy + vz * vz, w);
    if (even_spring_) {
      const double pull = body_.stiffness.x() * ratio;
      tx -= pull * vx;
      ty -= pull * vy;
      tz -= pull * vz;
    } else {
      const Vec3 torque = spring_torque({ratio * vx, ratio * vy, ratio * vz}, body_.stiffness);
      tx += torque.x();
      ty += torque.y();
      tz += torque.z();
    }
  }
}

Vec3 SpinRate::drive(const SpinVector& y) const noexcept {
  Vec3 torque;
  drive(y, torque.x(), torque.y(), torque.z());
  return torque;
}

inline SpinVector SpinRate::operator()(const SpinVector& y) const noexcept {
  double tx = 0.0;
  double ty = 0.0;
  double tz = 0.0;
  drive(y, tx, ty, tz);
  double a = y[4];
  double b = y[5];
  double c = y[6];
  if (massless_) {
    const Vec3 w_O = settled({tx, ty, tz}, {a, b, c});
    a = w_O.x();
    b = w_O.y();
    c = w_O.z();
  }
  const Vec3& I = body_.inertia_kg_m2;
  const Vec3& damping = body_.damping;
  SpinVector rate;
  rate[0] = -0.5 * (y[1] * a + y[2] * b + y[3] * c);
  rate[1] = 0.5 * (y[0] * a + y[2] * c - y[3] * b);
  rate[2] = 0.5 * (y[0] * b + y[3] * a - y[1] * c);
  rate[3] = 0.5 * (y[0] * c + y[1] * b - y[2] * a);
  rate[4] = inverse_inertia_.x() * (tx - damping.x() * a - (I.z() - I.y()) * b * c);
  rate[5] = inverse_inertia_.y() * (ty - damping.y() * b - (I.x() - I.z()) * c * a);
  rate[6] = inverse_inertia_.z() * (tz - damping.z() * c - (I.y() - I.x()) * a * b);
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

SpinStep explicit_step(const SpinRate& rate, const SpinVector& start, double h_s,
                       StageStates* seen) noexcept {
  std::array<SpinVector, 12> k;
  if (seen == nullptr)
    dormand_prince::stages(
        start, h_s, [&](std::size_t, const SpinVector& y) { return rate(y); }, k);
  else
    dormand_prince::stages(
        start, h_s,
        [&](std::size_t i, const SpinVector& y) {
          (*seen)[i] = y;
          return rate(y);
        },
        k);
  SpinStep step;
  step.end = start + h_s * dormand_prince::increment(k);
  const double error5 = angle_of(dormand_prince::error5(k));
  const double error3 = angle_of(dormand_prince::error3(k));
  const double both = error5 * error5 + 0.01 * error3 * error3;
  step.error_rad = both == 0.0 ? 0.0 : h_s * error5 * error5 / std::sqrt(both);
  return step;
}

}  // namespace isograsp::so3
