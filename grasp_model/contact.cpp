// SPDX-License-Identifier: GPL-3.0-or-later
// Friction limit of one contact, f_t = (fx, fy):
//   utilisation = sqrt((|f_t| / (mu fz))^2 + (tz / (gamma_m fz))^2)
//   passed on: fz, and (fx, fy, tz) / max(1, utilisation); nothing where fz <= 0
#include "grasp_model/contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isograsp {

namespace {

/// |(a, b)| by one square root; by hypot only where a square would over- or underflow.
double tangential_length(double a, double b) noexcept {
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

FrictionLimit::FrictionLimit(const Contact& contact) noexcept
    : tangential(contact.model != ContactModel::frictionless),
      torsional(contact.model == ContactModel::soft && contact.torsion_m > 0.0),
      mu(contact.friction),
      gamma_m(contact.torsion_m) {}

double utilisation(const FrictionLimit& limit, const Wrench& F_C) noexcept {
  const double fz = F_C.force.z();
  if (!(fz > 0.0) || !limit.tangential) return 0.0;
  const double sliding = share(tangential_length(F_C.force.x(), F_C.force.y()), limit.mu * fz);
  if (!limit.torsional || F_C.torque.z() == 0.0) return sliding;
  return tangential_length(sliding, share(std::abs(F_C.torque.z()), limit.gamma_m * fz));
}

ContactForce clamp_to_friction(const FrictionLimit& limit, const Wrench& F_C) noexcept {
  const double fz = F_C.force.z();
  if (!(fz > 0.0)) return {};
  if (!limit.tangential) return {0.0, 0.0, fz, 0.0, false};
  const double fx = F_C.force.x();
  const double fy = F_C.force.y();
  const double tz = limit.torsional ? F_C.torque.z() : 0.0;
  double kept = 1.0;
  if (tz == 0.0) {
    const double tangential = tangential_length(fx, fy);
    const double holds = limit.mu * fz;
    if (tangential > holds) kept = holds / tangential;
  } else {
    kept = 1.0 / std::max(1.0, utilisation(limit, F_C));
  }
  return {kept * fx, kept * fy, fz, kept * tz, kept < 1.0};
}

}  // namespace isograsp
