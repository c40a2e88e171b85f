// SPDX-License-Identifier: GPL-3.0-or-later
// With the mean of the diagonal taken off, A = N - (tr N / 4) I, the eigenvalues are the zeros of
//   P(x) = x^4 - (p2 / 2) x^2 - (p3 / 3) x + det A,   p_k = tr A^k
// (Newton's identities). All of them are real, so Newton's iteration from above, x_0 = sqrt(3 p2 /
// 4), falls to the largest one and never passes it. The columns of
//   adj(A - x I) = sum_i prod_{j != i} (x_j - x) v_i v_i^T
// are then multiples of its vector v. The Rayleigh quotient v^T A v squares the error of x, and the
// columns are taken once more. Where the two largest are equal the adjugate vanishes: powers of A +
// I then lead to one of their vectors.
#include "kinematics/largest_eigenvector.hpp"

#include <cmath>

namespace isograsp {

namespace {

/// The largest zero of P, to about the rounding of its coefficients.
double largest_eigenvalue(const Mat4& a) noexcept {
  const Mat4 square = a * a;
  const double p2 = square.trace();
  const double p3 = square.cwiseProduct(a).sum();
  const double c2 = -p2 / 2.0;
  const double c1 = -p3 / 3.0;
  const double c0 = a.determinant();
  constexpr int kMostSteps = 60;  // near two equal zeros a step only halves the distance
  double x = std::sqrt(0.75 * p2);
  for (int step = 0; step < kMostSteps; ++step) {
    const double slope = (4.0 * x * x + 2.0 * c2) * x + c1;
    const double value = ((x * x + c2) * x + c1) * x + c0;
    if (!(slope > 0.0) || !(value > 0.0)) break;
    const double next = x - value / slope;
    if (!(next < x)) break;
    x = next;
  }
  return x;
}

Vec4 longest_column(const Mat4& m) noexcept {
  Eigen::Index longest = 0;
  m.diagonal().cwiseAbs().maxCoeff(&longest);
  return m.col(longest);
}

/// Squared again and again, A + I (no eigenvalue below zero) becomes the projector on all that
/// belong to the largest eigenvalue. @pre |A| = 1
Vec4 of_equal_ones(const Mat4& a) noexcept {
  constexpr int kSquares = 50;  // tells apart what differs by the rounding of a double
  Mat4 power = a + Mat4::Identity();
  for (int i = 0; i < kSquares; ++i) {
    power = (power * power).eval();
    power /= power.norm();
  }
  return longest_column(power).normalized();
}

/// The longest column of adj(A - x I), not yet of length 1.
Vec4 adjugate_column(const Mat4& a, double x) noexcept {
  const Mat4 m = a - x * Mat4::Identity();
  // Determinants of two rows: of the upper two and of the lower two, by the columns i < j.
  const auto upper = [&m](int i, int j) { return m(0, i) * m(1, j) - m(0, j) * m(1, i); };
  const auto lower = [&m](int i, int j) { return m(2, i) * m(3, j) - m(2, j) * m(3, i); };
  const double u01 = upper(0, 1), u02 = upper(0, 2), u03 = upper(0, 3);
  const double u12 = upper(1, 2), u13 = upper(1, 3), u23 = upper(2, 3);
  const double l01 = lower(0, 1), l02 = lower(0, 2), l03 = lower(0, 3);
  const double l12 = lower(1, 2), l13 = lower(1, 3), l23 = lower(2, 3);
  const Vec4 diagonal(
      m(1, 1) * l23 - m(1, 2) * l13 + m(1, 3) * l12, m(0, 0) * l23 - m(0, 2) * l03 + m(0, 3) * l02,
      m(3, 0) * u13 - m(3, 1) * u03 + m(3, 3) * u01, m(2, 0) * u12 - m(2, 1) * u02 + m(2, 2) * u01);
  Eigen::Index longest = 0;
  diagonal.cwiseAbs().maxCoeff(&longest);
  switch (longest) {
    case 0:
      return {diagonal[0], -m(1, 0) * l23 + m(1, 2) * l03 - m(1, 3) * l02,
              m(1, 0) * l13 - m(1, 1) * l03 + m(1, 3) * l01,
              -m(1, 0) * l12 + m(1, 1) * l02 - m(1, 2) * l01};
    case 1:
      return {-m(0, 1) * l23 + m(0, 2) * l13 - m(0, 3) * l12, diagonal[1],
              -m(0, 0) * l13 + m(0, 1) * l03 - m(0, 3) * l01,
              m(0, 0) * l12 - m(0, 1) * l02 + m(0, 2) * l01};
    case 2:
      return {m(3, 1) * u23 - m(3, 2) * u13 + m(3, 3) * u12,
              -m(3, 0) * u23 + m(3, 2) * u03 - m(3, 3) * u02, diagonal[2],
              -m(3, 0) * u12 + m(3, 1) * u02 - m(3, 2) * u01};
    default:
      return {-m(2, 1) * u23 + m(2, 2) * u13 - m(2, 3) * u12,
              m(2, 0) * u23 - m(2, 2) * u03 + m(2, 3) * u02,
              -m(2, 0) * u13 + m(2, 1) * u03 - m(2, 3) * u01, diagonal[3]};
  }
}

}  // namespace

Vec4 largest_eigenvector(const Mat4& n) noexcept {
  const Mat4 centred = n - n.trace() / 4.0 * Mat4::Identity();
  const double size = centred.norm();
  if (!(size > 0.0)) return Vec4::UnitX();  // all vectors are eigenvectors
  const Mat4 a = centred / size;
  // Shorter: a second eigenvalue is so near that the columns contain only rounding.
  constexpr double kShortest = 1e-9;
  const Vec4 first = adjugate_column(a, largest_eigenvalue(a));
  if (first.norm() > kShortest) {
    const Vec4 v = first.normalized();
    const Vec4 column = adjugate_column(a, v.dot(a * v));
    if (column.norm() > kShortest) return column.normalized();
  }
  return of_equal_ones(a);
}

}  // namespace isograsp
