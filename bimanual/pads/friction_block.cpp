// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/pads/friction_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace isograsp::bimanual {

namespace {

/// Eigenvalues, and directions as columns, of what is symmetric.
std::pair<Eigen::Vector3d, Eigen::Matrix3d> axes_of(const Eigen::Matrix3d& symmetric) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(symmetric);
  return {eigen.eigenvalues(), eigen.eigenvectors()};
}

/// Two rows are tridiagonal as they are: the same steps and bits without the reduction to that
/// form, which a compiler works on for seven seconds.
std::pair<Eigen::Vector2d, Eigen::Matrix2d> axes_of(const Eigen::Matrix2d& symmetric) {
  using One = Eigen::Matrix<double, 1, 1>;
  Eigen::Vector2d diagonal = symmetric.diagonal();
  double below = symmetric(1, 0);
  double scale = std::max(diagonal.cwiseAbs().maxCoeff(), std::abs(below));
  if (scale == 0.0) scale = 1.0;
  diagonal /= scale;
  below /= scale;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
  eigen.computeFromTridiagonal(diagonal, One(below));
  return {eigen.eigenvalues() * scale, eigen.eigenvectors()};
}

}  // namespace

template <int N>
Eigen::Matrix<double, N, 1> friction_in_ellipsoid(const Eigen::Matrix<double, N, N>& W,
                                                  const Eigen::Matrix<double, N, 1>& slip_free,
                                                  const Eigen::Matrix<double, N, 1>& limits) {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  if (limits.minCoeff() > 0.0) {
    const Vector sticks = W.llt().solve(slip_free);
    if (sticks.cwiseQuotient(limits).squaredNorm() <= 1.0) return sticks;
  } else if (limits.isZero()) {
    return Vector::Zero();
  }
  // f = D y: the ellipsoid is the unit ball of y, and D u its outward normal.
  const Matrix scaled = limits.asDiagonal() * W * limits.asDiagonal();
  const std::pair<Vector, Matrix> axes = axes_of(scaled);
  const Matrix& directions = axes.second;
  const Vector b = directions.transpose() * limits.cwiseProduct(slip_free);
  const Vector beta = axes.first.cwiseMax(0.0);
  const auto at = [&](double s) {
    Vector y;
    for (int i = 0; i < N; ++i) y[i] = b[i] == 0.0 ? 0.0 : b[i] / (beta[i] + s);
    return y;
  };
  const auto answer = [&](const Vector& y) -> Vector {
    return limits.cwiseProduct(directions * y);
  };
  // A direction without stiffness is one without a limit: nothing is asked of it.
  const double least = 1e-14 * beta.maxCoeff();
  Vector stick = at(0.0);
  for (int i = 0; i < N; ++i)
    if (!(beta[i] > least)) stick[i] = 0.0;
  if (!(stick.norm() > 1.0)) return answer(stick);
  // 1/|y(s)| is concave and grows: Newton from a place left of the root comes from there.
  double s = 0.0;
  constexpr int kMostSteps = 100;
  constexpr double kOnSurface = 1e-14;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vector y = step == 0 ? stick : at(s);
    const double norm = y.norm();
    if (std::abs(norm - 1.0) <= kOnSurface) break;
    double slope = 0.0;  // of |y|² / 2, negative
    for (int i = 0; i < N; ++i)
      if (beta[i] + s > least) slope -= y[i] * y[i] / (beta[i] + s);
    if (slope == 0.0) break;
    const double next = s - norm * norm * (norm - 1.0) / slope;
    if (!(std::abs(next - s) > 1e-16 * next)) break;
    s = next > 0.0 ? next : 0.0;
  }
  const Vector y = at(s);
  return answer(y / std::max(1.0, y.norm()));
}

template Eigen::Vector2d friction_in_ellipsoid<2>(const Eigen::Matrix2d&, const Eigen::Vector2d&,
                                                  const Eigen::Vector2d&);
template Eigen::Vector3d friction_in_ellipsoid<3>(const Eigen::Matrix3d&, const Eigen::Vector3d&,
                                                  const Eigen::Vector3d&);

}  // namespace isograsp::bimanual
