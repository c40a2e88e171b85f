// SPDX-License-Identifier: GPL-3.0-or-later
// m x" + C x' + K x = F on the free axes, F constant over the hold h:
//   d/dt (x, v, F) = rate (x, v, F),  x1 = x0 + S v0 + P (F - K x0),  v1 = Q v0 + T (F - K x0)
//   S, P, Q and T are blocks of exp(h rate)
// m = 0: d/dt (x, F) = rate (x, F), P a block of exp(h rate), T = C^-1 (I - K P).
#include "grasp_model/coupled.hpp"

#include <vector>

#include <Eigen/LU>
#include <unsupported/Eigen/MatrixFunctions>

namespace isograsp {

namespace {

// Scaling and squaring loses a digit for every factor of ten of the fastest rate: the extended
// format keeps the result exact to a double for rates up to some 1e3 per hold.
using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Matrix block_of(const Mat3& matrix, const std::vector<Eigen::Index>& axes) {
  return matrix(axes, axes).cast<long double>();
}

void scatter(const Matrix& from, const std::vector<Eigen::Index>& axes, Mat3& to) {
  to(axes, axes) = from.cast<double>();
}

std::vector<Eigen::Index> axes_of(const std::array<bool, 3>& free) {
  std::vector<Eigen::Index> axes;
  for (std::size_t i = 0; i < 3; ++i)
    if (free[i]) axes.push_back(static_cast<Eigen::Index>(i));
  return axes;
}

}  // namespace

bool CoupledAxes::coupled() const noexcept {
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      if (free[static_cast<std::size_t>(i)] && free[static_cast<std::size_t>(j)] &&
          (stiffness(i, j) != 0.0 || damping(i, j) != 0.0))
        return true;
  return false;
}

CoupledStep::CoupledStep(const CoupledAxes& axes, double hold_s) {
  const auto free = axes_of(axes.free);
  const auto n = static_cast<Eigen::Index>(free.size());
  const Matrix K = block_of(axes.stiffness, free);
  const Matrix C = block_of(axes.damping, free);
  const long double h = hold_s;
  const Matrix I = Matrix::Identity(n, n);
  scatter(K, free, stiffness_);
  if (axes.mass_kg == 0.0) {
    const Matrix inverse = C.inverse();
    Matrix rate = Matrix::Zero(2 * n, 2 * n);  // of (x, F)
    rate.topLeftCorner(n, n) = -inverse * K;
    rate.topRightCorner(n, n) = inverse;
    const Matrix P = Matrix((h * rate).exp()).topRightCorner(n, n);
    scatter(P, free, P_);
    scatter(inverse * (I - K * P), free, T_);
    return;
  }
  const long double m = axes.mass_kg;
  Matrix rate = Matrix::Zero(3 * n, 3 * n);  // of (x, v, F)
  rate.block(0, n, n, n) = I;
  rate.block(n, 0, n, n) = -K / m;
  rate.block(n, n, n, n) = -C / m;
  rate.block(n, 2 * n, n, n) = I / m;
  const Matrix end = (h * rate).exp();
  scatter(end.block(0, n, n, n), free, S_);
  scatter(end.block(0, 2 * n, n, n), free, P_);
  scatter(end.block(n, n, n, n), free, Q_);
  scatter(end.block(n, 2 * n, n, n), free, T_);
}

}  // namespace isograsp
