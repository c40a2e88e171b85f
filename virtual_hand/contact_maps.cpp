// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/contact_maps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace isograsp::virtual_hand {

namespace {

constexpr int kCoordinates = 4;
using Six = Eigen::Matrix<double, 6, 6>;

/// Rank by the rounding of the largest singular value: a map of fewer contacts than it needs has a
/// last one that is rounding, and no inverse.
bool full_rank(const SixValues& six, int columns) noexcept {
  const double rounding =
      6.0 * std::numeric_limits<double>::epsilon() * six.values[0] * std::max(6, columns);
  return six.values[5] > rounding;
}

}  // namespace

ContactMaps contact_maps(const DigitContact& contact) noexcept {
  ContactMaps maps;
  maps.digit = contact.digit;
  maps.distance2_m2 = contact.p_OC.squaredNorm();
  maps.G.topLeftCorner<3, 3>() = contact.R_OC;
  maps.G.bottomLeftCorner<3, 3>() = skew(contact.p_OC) * contact.R_OC;
  maps.G.col(3) << Vec3::Zero(), contact.R_OC.col(2);
  maps.J.setZero();
  return maps;
}

ContactMaps contact_maps(const DigitContact& contact, const HandInSpace& hand,
                         const Pose& X_WO) noexcept {
  ContactMaps maps = contact_maps(contact);
  const Mat3 R_CW = (X_WO.q.toRotationMatrix() * contact.R_OC).transpose();
  const PointJacobian of_point =
      point_jacobian(hand, contact.digit, contact.link, X_WO.p + X_WO.q * contact.p_OC);
  const auto angles = of_point.middleCols<static_cast<int>(kAngleCount)>(
      static_cast<Eigen::Index>(6 + index_of(contact.digit) * kAngleCount));
  maps.J.topRows<3>() = R_CW * angles.topRows<3>();
  maps.J.row(3) = R_CW.row(2) * angles.bottomRows<3>();
  return maps;
}

DigitSet ContactSet::digits() const noexcept {
  DigitSet digits = 0;
  for (std::size_t k = 0; k < count; ++k) digits |= 1U << index_of(contacts[k]->digit);
  return digits;
}

double ContactSet::length_m() const noexcept {
  double sum_m2 = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum_m2 += contacts[k]->distance2_m2;
  return sum_m2 > 0.0 ? std::sqrt(sum_m2 / static_cast<double>(count)) : 1.0;
}

SixValues six_values(const Six& R) noexcept {
  const Eigen::Matrix<double, 6, 1> singular = Eigen::JacobiSVD<Six>(R).singularValues();
  SixValues six;
  for (std::size_t k = 0; k < 6; ++k) six.values[k] = singular[static_cast<Eigen::Index>(k)];
  six.least = six.values[5];
  six.product = std::abs(R.diagonal().prod());
  return six;
}

SetFactors factors_of(const ContactSet& set, const MapScales& scales) noexcept {
  // Contacts that are not there are rows of zeros, which no factor sees.
  constexpr int kRows = kCoordinates * static_cast<int>(ContactSet::kMost);
  using Tall = Eigen::Matrix<double, kRows, 6>;
  const int count = static_cast<int>(set.count);
  Tall Gt = Tall::Zero();
  for (int k = 0; k < count; ++k)
    Gt.middleRows<kCoordinates>(kCoordinates * k) =
        set.contacts[static_cast<std::size_t>(k)]->G.transpose();
  Gt.rightCols<3>() /= scales.torque_m;
  for (int k = 0; k < count; ++k) Gt.row(kCoordinates * k + 3) *= scales.torsion_m;
  const Eigen::HouseholderQR<Tall> qr(Gt);
  const Six R = qr.matrixQR().topRows<6>().triangularView<Eigen::Upper>();
  SetFactors factors;
  factors.G = six_values(R);
  if (!full_rank(factors.G, kCoordinates * count)) {
    factors.G.least = factors.G.product = 0.0;
    return factors;
  }
  // H = (G^T)^+ D J = R^-1 Q^T D J; its transpose is factored.
  const Tall Q = qr.householderQ() * Tall::Identity();
  Eigen::Matrix<double, 6, kRows> H = Eigen::Matrix<double, 6, kRows>::Zero();
  for (int k = 0; k < count; ++k) {
    Eigen::Matrix4d DJ = set.contacts[static_cast<std::size_t>(k)]->J / scales.hand_m;
    DJ.row(3) *= scales.torsion_m;
    H.middleCols<kCoordinates>(kCoordinates * k) =
        Q.middleRows<kCoordinates>(kCoordinates * k).transpose() * DJ;
  }
  R.triangularView<Eigen::Upper>().solveInPlace(H);
  factors.H = Eigen::HouseholderQR<Tall>(H.transpose())
                  .matrixQR()
                  .topRows<6>()
                  .triangularView<Eigen::Upper>();
  return factors;
}

// Coordinates x of a contact: normal force, then tangential forces / mu and torque / its limit per
// newton; its cone is q(x) = x0^2 - |x_t|^2 > 0, x0 > 0, with the barrier -log q. In the metric of
// the barrier (inverse Hessian M = x x^T - q/2 diag(1, -1, -1, -1)) the forces without a wrench
// that are nearest to x are p = x - M A^T nu / 2, with A M A^T nu = 2 A x. If p is inside, the
// grasp closes. If A^T nu is inside all cones, nu is a wrench that every contact force does work
// against, and it does not. Else x takes the step of Newton's method for the least barrier, x + t
// (2 p - x).
bool closes(const ContactSet& set, const PadFriction& friction) noexcept {
  constexpr int kMostSteps = 100;    // none to five are usual
  constexpr double kInside = 1e-9;   // of the normal force: more than rounding
  constexpr double kToTheRim = 0.9;  // of the way to the edge of a cone
  constexpr std::size_t kMost = ContactSet::kMost;
  using Vec4 = Eigen::Vector4d;
  const Vec4 signs(1.0, -1.0, -1.0, -1.0);
  const double length_m = set.length_m();
  std::array<Eigen::Matrix<double, 6, 4>, kMost> A;
  std::array<Six, kMost> AJA;
  std::array<Vec4, kMost> x;
  for (std::size_t k = 0; k < set.count; ++k) {
    const auto& G = set.contacts[k]->G;
    const double mu = friction.friction;
    A[k] << G.col(2), mu * G.col(0), mu * G.col(1), mu * friction.torsion_m() * G.col(3);
    A[k].bottomRows<3>() /= length_m;
    AJA[k] = A[k] * signs.asDiagonal() * A[k].transpose();
    x[k] = Vec4::UnitX();
  }
  const auto form = [&](const Vec4& a, const Vec4& b) { return a.dot(signs.cwiseProduct(b)); };
  const auto inside = [&](const Vec4& v) { return v[0] - v.tail<3>().norm() > kInside * v[0]; };
  for (int step = 0; step < kMostSteps; ++step) {
    Eigen::Matrix<double, 6, 1> wrench = Eigen::Matrix<double, 6, 1>::Zero();
    Six metric = Six::Zero();
    for (std::size_t k = 0; k < set.count; ++k) {
      const Eigen::Matrix<double, 6, 1> part = A[k] * x[k];
      wrench += part;
      metric += part * part.transpose() - 0.5 * form(x[k], x[k]) * AJA[k];
    }
    const Eigen::LLT<Six> factored(metric);
    if (factored.info() != Eigen::Success) return false;
    const Eigen::Matrix<double, 6, 1> nu = factored.solve(2.0 * wrench);
    bool holds = true;
    bool opens = true;
    double longest = std::numeric_limits<double>::infinity();
    std::array<Vec4, kMost> way;
    for (std::size_t k = 0; k < set.count; ++k) {
      const Vec4 work = A[k].transpose() * nu;
      const double q = form(x[k], x[k]);
      const Vec4 nearest =
          x[k] - 0.5 * (x[k] * x[k].dot(work) - 0.5 * q * signs.cwiseProduct(work));
      holds = holds && nearest[0] > 0.0 && inside(nearest);
      opens = opens && work[0] > 0.0 && inside(work);
      way[k] = 2.0 * nearest - x[k];
      // Where x + t way leaves the cone: the least positive root of the form.
      const double a = form(way[k], way[k]);
      const double b = form(x[k], way[k]);
      const double root = std::sqrt(std::max(0.0, b * b - a * q));
      const double t =
          a < 0.0 || b < 0.0 ? q / (root - b) : std::numeric_limits<double>::infinity();
      if (t > 0.0) longest = std::min(longest, t);
    }
    if (holds) return true;
    if (opens) return false;
    const double t = std::min(1.0, kToTheRim * longest);
    if (!(t > 0.0)) return false;
    double sum = 0.0;
    for (std::size_t k = 0; k < set.count; ++k) sum += (x[k] += t * way[k])[0];
    for (std::size_t k = 0; k < set.count; ++k) x[k] /= sum;
  }
  return false;
}

}  // namespace isograsp::virtual_hand
