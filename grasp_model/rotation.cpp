// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/rotation.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace isograsp::so3 {

namespace {

double length(const Vec3& v) noexcept {
  const double square = v.squaredNorm();
  return square > 1e-280 && square < 1e280 ? std::sqrt(square) : v.stableNorm();
}

/// (1 - (t/2) cot(t/2)) / t^2, even in t, pole at 2 pi.
double cotangent_term(double t) noexcept {
  constexpr double kSeries_rad = 0.05;
  const double t2 = t * t;
  if (t < kSeries_rad) return 1.0 / 12.0 + t2 * (1.0 / 720.0 + t2 / 30240.0);
  return (1.0 - 0.5 * t / std::tan(0.5 * t)) / t2;
}

}  // namespace

Quat exp(const Vec3& phi) noexcept {
  const double half = 0.5 * length(phi);
  const double scale = half == 0.0 ? 0.5 : 0.5 * std::sin(half) / half;
  return {std::cos(half), scale * phi.x(), scale * phi.y(), scale * phi.z()};
}

Vec3 log(const Quat& q) noexcept {
  const double v = length(q.vec());
  if (v == 0.0) return 2.0 / q.w() * q.vec();
  return 2.0 * std::atan2(v, q.w()) / v * q.vec();
}

Vec3 jr(const Vec3& phi, const Vec3& u) noexcept {
  constexpr double kSeries_rad = 0.05;
  const double t2 = phi.squaredNorm();
  const double t = std::sqrt(t2);
  double a = 0.5 - t2 * (1.0 / 24.0 - t2 / 720.0);          // (1 - cos t) / t^2
  double b = 1.0 / 6.0 - t2 * (1.0 / 120.0 - t2 / 5040.0);  // (t - sin t) / t^3
  if (t >= kSeries_rad) {
    const double half = std::sin(0.5 * t);
    a = 2.0 * half * half / t2;
    b = (t - std::sin(t)) / (t2 * t);
  }
  const Vec3 cross = phi.cross(u);
  return u - a * cross + b * phi.cross(cross);
}

Vec3 jr_inverse(const Vec3& phi, const Vec3& u) noexcept {
  const Vec3 cross = phi.cross(u);
  return u + 0.5 * cross + cotangent_term(phi.norm()) * phi.cross(cross);
}

Vec3 jr_inverse_transpose(const Vec3& phi, const Vec3& u) noexcept {
  const Vec3 cross = phi.cross(u);
  return u - 0.5 * cross + cotangent_term(phi.norm()) * phi.cross(cross);
}

Vec3 spring_torque(const Vec3& phi, const Vec3& k) noexcept {
  if (k.x() == k.y() && k.y() == k.z()) return -k.x() * phi;  // phi is an eigenvector of Jr
  const Vec3 linear = k.cwiseProduct(phi);
  const Vec3 cross = phi.cross(linear);
  const double d = cotangent_term(std::min(phi.norm(), kSpringReach_rad));
  return -(linear - 0.5 * cross + d * phi.cross(cross));
}

namespace {

/// Body torque of everything but the gyroscopic and damping terms.
Vec3 drive(const Body& body, const Torques& torques, const Quat& q_WO) noexcept {
  Vec3 torque = torques.body;
  if (!torques.world.isZero(0.0)) torque += q_WO.conjugate() * torques.world;
  if (!body.stiffness.isZero(0.0)) torque += spring_torque(log(q_WO), body.stiffness);
  return torque;
}

/// An axis without inertia has no velocity of its own: damping and the rest balance at once.
Vec3 settled(const Body& body, const Vec3& driving, Vec3 w_O) noexcept {
  const Vec3& I = body.inertia_kg_m2;
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (I[i] != 0.0) continue;
    const Eigen::Index j = (i + 1) % 3;
    const Eigen::Index k = (i + 2) % 3;
    // (w x I w)_i; for a massless body it is 0, so the order of the axes does not matter.
    w_O[i] = (driving[i] - (I[k] - I[j]) * w_O[j] * w_O[k]) / body.damping[i];
  }
  return w_O;
}

struct Rate {
  Vec3 w_O;    ///< angular velocity, massless axes settled
  Vec3 alpha;  ///< its derivative, 0 on massless axes
};

Rate rate(const Body& body, const Torques& torques, const Quat& q_WO, const Vec3& w_O) noexcept {
  const Vec3 driving = drive(body, torques, q_WO);
  const Vec3& I = body.inertia_kg_m2;
  const Vec3 w = settled(body, driving, w_O);
  const Vec3 torque = driving - body.damping.cwiseProduct(w) - w.cross(I.cwiseProduct(w).eval());
  Vec3 alpha;
  for (Eigen::Index i = 0; i < 3; ++i) alpha[i] = I[i] == 0.0 ? 0.0 : torque[i] / I[i];
  return {w, alpha};
}

}  // namespace

double fastest_rate(const Body& body, const Torques& torques, const Spin& spin,
                    double hold_s) noexcept {
  const double torque = torques.world.norm() + torques.body.norm();
  double spring = 0.0;
  double damper = 0.0;
  double massless = 0.0;
  double gained = 0.0;  // speed
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double I = body.inertia_kg_m2[i];
    if (I == 0.0) {
      massless = std::max(massless, body.stiffness[i] / body.damping[i]);
      gained = std::max(gained, torque / body.damping[i]);
    } else {
      spring = std::max(spring, body.stiffness[i] / I);
      damper = std::max(damper, body.damping[i] / I);
      gained = std::max(gained, torque / std::max(I / hold_s, body.damping[i]));
    }
  }
  return spin.w_O.norm() + gained + std::sqrt(spring) + damper + massless;
}

Division divide(double rate, double hold_s) noexcept {
  const double turn = rate * hold_s;
  Division division;
  if (turn <= kSubstep_rad * kMostSubsteps) {
    division.substeps = std::max(1, static_cast<int>(std::ceil(turn / kSubstep_rad)));
  } else {
    division.substeps = kMostSubsteps;
    division.tolerance_exceeded = true;
    division.implicit = !(turn <= kStable_rad * kMostSubsteps);
  }
  return division;
}

void rkmk4(const Body& body, const Torques& torques, double h_s, Spin& spin) noexcept {
  const Quat q = spin.q_WO;
  const Vec3 w = spin.w_O;
  const Rate k1 = rate(body, torques, q, w);
  const Vec3 u2 = 0.5 * h_s * k1.w_O;
  const Rate k2 = rate(body, torques, q * exp(u2), w + 0.5 * h_s * k1.alpha);
  const Vec3 d2 = jr_inverse(u2, k2.w_O);
  const Vec3 u3 = 0.5 * h_s * d2;
  const Rate k3 = rate(body, torques, q * exp(u3), w + 0.5 * h_s * k2.alpha);
  const Vec3 d3 = jr_inverse(u3, k3.w_O);
  const Vec3 u4 = h_s * d3;
  const Rate k4 = rate(body, torques, q * exp(u4), w + h_s * k3.alpha);
  const Vec3 d4 = jr_inverse(u4, k4.w_O);
  spin.q_WO = q * exp(h_s / 6.0 * (k1.w_O + 2.0 * (d2 + d3) + d4));
  spin.w_O = w + h_s / 6.0 * (k1.alpha + 2.0 * (k2.alpha + k3.alpha) + k4.alpha);
  if (body.inertia_kg_m2.minCoeff() == 0.0)
    spin.w_O = settled(body, drive(body, torques, spin.q_WO), spin.w_O);
}

void implicit_step(const Body& body, const Torques& torques, double h_s, Spin& spin) noexcept {
  const Vec3& I = body.inertia_kg_m2;
  const Vec3 w = spin.w_O;
  const Vec3 momentum = I.cwiseProduct(w);
  // Spring Jacobian in the body axes, Jr^-T diag(k) Jr^-1: symmetric and not negative.
  Mat3 stiffness = Mat3::Zero();
  if (!body.stiffness.isZero(0.0)) {
    const Vec3 phi = log(spin.q_WO);
    const double angle = phi.norm();
    const Vec3 reached = angle > kSpringReach_rad ? Vec3(phi * (kSpringReach_rad / angle)) : phi;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vec3 column = body.stiffness.cwiseProduct(jr_inverse(reached, Vec3::Unit(i)));
      stiffness.col(i) = jr_inverse_transpose(reached, column);
    }
  }
  const Mat3 gyroscopic = skew(w) * Mat3(I.asDiagonal()) - skew(momentum);
  Mat3 matrix = I.asDiagonal();
  matrix += h_s * (Mat3(body.damping.asDiagonal()) + gyroscopic) + h_s * h_s * stiffness;
  // (I + h C + h^2 K + h G) w1 = I w0 + h (drive(q0) - w0 x I w0 + G w0); G w0 = w0 x I w0
  const Vec3 right =
      momentum + h_s * (drive(body, torques, spin.q_WO) - w.cross(momentum) + gyroscopic * w);
  spin.w_O = matrix.inverse() * right;
  spin.q_WO = spin.q_WO * exp(h_s * spin.w_O);
}

}  // namespace isograsp::so3
