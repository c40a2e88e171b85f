// SPDX-License-Identifier: GPL-3.0-or-later
#include "grasp_model/contact.hpp"

#include <cmath>
#include <limits>

namespace isograsp {

namespace {

/// |(a, b)| at the price of a square root; hypot only where a square would leave the doubles.
double length(double a, double b) noexcept {
  const double square = a * a + b * b;
  if (square > 1e-280 && square < 1e280) return std::sqrt(square);
  return std::hypot(a, b);
}

/// Share of a limit; a load on a limit of zero is infinitely much.
double share(double load, double limit) noexcept {
  if (load == 0.0) return 0.0;
  return limit > 0.0 ? load / limit : std::numeric_limits<double>::infinity();
}

}  // namespace

bool in_contact(bool was, double fz_N, double threshold_N) noexcept {
  return fz_N > (was ? 0.5 * threshold_N : threshold_N);
}

Transmitted transmit(const Contact& contact, const Wrench& F_C) noexcept {
  Transmitted out;
  const double fz = F_C.force.z();
  if (!(fz > 0.0)) return out;
  out.F_C.force.z() = fz;
  if (contact.model == ContactModel::frictionless) return out;

  const double fx = F_C.force.x();
  const double fy = F_C.force.y();
  const double tz = F_C.torque.z();
  const bool torsion = contact.model == ContactModel::soft && contact.torsion_m > 0.0;
  const double limit_N = contact.friction * fz;
  const double tangential_N = length(fx, fy);
  const double sliding = share(tangential_N, limit_N);
  const double turning = torsion ? share(std::abs(tz), contact.torsion_m * fz) : 0.0;
  out.utilisation = turning == 0.0 ? sliding : length(sliding, turning);
  double kept = 1.0;
  if (out.slip()) kept = turning == 0.0 ? limit_N / tangential_N : 1.0 / out.utilisation;
  out.F_C.force.x() = kept * fx;
  out.F_C.force.y() = kept * fy;
  if (torsion) out.F_C.torque.z() = kept * tz;
  return out;
}

}  // namespace isograsp
