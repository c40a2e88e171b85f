// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/tracked_link.hpp"

#include "kinematics/attitude.hpp"

namespace isograsp::virtual_hand {

namespace {

Vec3 at_most(const Vec3& value, double most) noexcept {
  const double size = value.norm();
  return size > most ? Vec3(value * (most / size)) : value;
}

}  // namespace

Wrench coupling_wrench(const LinkCoupling& coupling, const LinkMotion& is,
                       const LinkMotion& tracked) noexcept {
  const Vec3 turn = rotation_vector(tracked.X_W.q * is.X_W.q.conjugate());
  Wrench wrench;
  wrench.force = at_most(coupling.stiffness_N_m * (tracked.X_W.p - is.X_W.p) +
                             coupling.damping_N_s_m * (tracked.v_m_s - is.v_m_s),
                         coupling.most_N);
  wrench.torque = at_most(coupling.stiffness_N_m_rad * turn +
                              coupling.damping_N_m_s_rad * (tracked.w_rad_s - is.w_rad_s),
                          coupling.most_N_m);
  return wrench;
}

}  // namespace isograsp::virtual_hand
