// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/friction_block.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace isograsp::bimanual {

Vec3 friction_in_ellipsoid(const Mat3& W, const Vec3& slip_free, const Vec3& limits) {
  if (limits.minCoeff() > 0.0) {
    const Vec3 sticks = W.llt().solve(slip_free);
    if (sticks.cwiseQuotient(limits).squaredNorm() <= 1.0) return sticks;
  } else if (limits.isZero()) {
    return Vec3::Zero();
  }
  // f = D y: the ellipsoid is the unit ball of y, and D u its outward normal.
  const Mat3 scaled = limits.asDiagonal() * W * limits.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(scaled);
  const Mat3& directions = axes.eigenvectors();
  const Vec3 b = directions.transpose() * limits.cwiseProduct(slip_free);
  const Vec3 beta = axes.eigenvalues().cwiseMax(0.0);
  const auto at = [&](double s) {
    Vec3 y;
    for (int i = 0; i < 3; ++i) y[i] = b[i] == 0.0 ? 0.0 : b[i] / (beta[i] + s);
    return y;
  };
  const auto answer = [&](const Vec3& y) -> Vec3 { return limits.cwiseProduct(directions * y); };
  // A direction without stiffness is one without a limit: nothing is asked of it.
  const double least = 1e-14 * beta.maxCoeff();
  Vec3 stick = at(0.0);
  for (int i = 0; i < 3; ++i)
    if (!(beta[i] > least)) stick[i] = 0.0;
  if (!(stick.norm() > 1.0)) return answer(stick);
  // 1/|y(s)| is concave and grows: Newton from a place left of the root comes from there.
  double s = 0.0;
  constexpr int kMostSteps = 100;
  constexpr double kOnSurface = 1e-14;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec3 y = step == 0 ? stick : at(s);
    const double norm = y.norm();
    if (std::abs(norm - 1.0) <= kOnSurface) break;
    double slope = 0.0;  // of |y|² / 2, negative
    for (int i = 0; i < 3; ++i)
      if (beta[i] + s > least) slope -= y[i] * y[i] / (beta[i] + s);
    if (slope == 0.0) break;
    const double next = s - norm * norm * (norm - 1.0) / slope;
    if (!(std::abs(next - s) > 1e-16 * next)) break;
    s = next > 0.0 ? next : 0.0;
  }
  const Vec3 y = at(s);
  return answer(y / std::max(1.0, y.norm()));
}

}  // namespace isograsp::bimanual
