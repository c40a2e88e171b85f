// SPDX-License-Identifier: GPL-3.0-or-later
// The step for bodies too stiff for an explicit one, and the motion inside it.
#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "grasp_model/rotation.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp::so3 {

namespace {

/// One linearly implicit Euler step: I w1 = I w0 + h (torque at the end, linearised at the start).
SpinVector implicit_euler(const SpinRate& rate, const SpinVector& y, double h_s) noexcept {
  const Body& body = rate.body();
  const Vec3& I = body.inertia_kg_m2;
  const Vec3 w_O = y.segment<3>(4);
  const Vec3 momentum = I.cwiseProduct(w_O);
  Mat3 matrix = I.asDiagonal();
  matrix += h_s * Mat3(body.damping.asDiagonal());
  // Gyroscopic term w x I w and its derivative.
  const Mat3 gyroscopic = skew(w_O) * Mat3(I.asDiagonal()) - skew(momentum);
  matrix += h_s * gyroscopic;
  if (!body.stiffness.isZero(0.0)) {
    // Spring stiffness in body axes, Jr^-T diag(k) Jr^-1: symmetric and not negative.
    const Vec3 phi = log(Quat(y[0], y[1], y[2], y[3]));
    const double angle = phi.norm();
    const Vec3 reached = angle > kSpringReach_rad ? Vec3(phi * (kSpringReach_rad / angle)) : phi;
    Mat3 stiffness;
    for (Eigen::Index i = 0; i < 3; ++i)
      stiffness.col(i) = jr_inverse_transpose(
          reached, body.stiffness.cwiseProduct(jr_inverse(reached, Vec3::Unit(i))));
    matrix += h_s * h_s * stiffness;
  }
  // (I + h C + h^2 K + h G) w1 = I w0 + h (drive(q0) - w0 x I w0 + G w0), G w0 = w0 x I w0
  const Vec3 right = momentum + h_s * (rate.drive(y) - w_O.cross(momentum) + gyroscopic * w_O);
  const Vec3 w_end = matrix.inverse() * right;
  const Quat q_end = Quat(y[0], y[1], y[2], y[3]) * exp(h_s * w_end);
  SpinVector end = pack({q_end, w_end});
  if (rate.watched()) end[7] = y[7] + h_s * rate.power(end);
  return end;
}

}  // namespace

SpinVector between(const SpinVector& start, const SpinVector& end, double h_s,
                   double share) noexcept {
  const Spin from = unpack(start);
  const Spin to = unpack(end);
  const Vec3 turned = log(from.q_WO.conjugate() * to.q_WO);
  const Vec3 speed_at_end = jr_inverse(turned, to.w_O);
  const double t = share;
  const Vec3 u = t * t * (3.0 - 2.0 * t) * turned +
                 h_s * t * (1.0 - t) * ((1.0 - t) * from.w_O - t * speed_at_end);
  return pack({from.q_WO * exp(u), from.w_O});
}

SpinStep stiff_step(const SpinRate& rate, const SpinVector& start, double h_s) noexcept {
  // Aitken-Neville in the number of substeps 1, 2, 3 …: each column gains an order.
  constexpr std::size_t kColumns = 6;
  std::array<SpinVector, kColumns> table;
  table.fill(start);
  SpinVector previous = start;
  for (std::size_t j = 0; j < kColumns; ++j) {
    const auto substeps = static_cast<double>(j + 1);
    SpinVector y = start;
    for (std::size_t i = 0; i <= j; ++i) y = implicit_euler(rate, y, h_s / substeps);
    // table[l] holds the value extrapolated l times for j substeps.
    SpinVector diagonal = table[0];
    table[0] = y;
    for (std::size_t l = 1; l <= j; ++l) {
      const double ratio = substeps / static_cast<double>(j + 1 - l);
      const SpinVector better = table[l - 1] + (table[l - 1] - diagonal) / (ratio - 1.0);
      diagonal = table[l];
      table[l] = better;
    }
    if (j + 1 == kColumns) previous = table[j - 1];
  }
  SpinStep step;
  step.end = table[kColumns - 1];
  step.error_rad = angle_of(step.end - previous);
  return step;
}

}  // namespace isograsp::so3
