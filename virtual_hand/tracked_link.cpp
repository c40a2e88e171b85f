// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_hand/tracked_link.hpp"

#include "kinematics/attitude.hpp"

namespace isograsp::virtual_hand {

namespace {

/// 1, or what keeps `size` at `most`.
double share_of(double size, double most) noexcept {
  return size > most ? most / size : 1.0;
}

}  // namespace

CoupledLink coupled_link(const LinkCoupling& coupling, const LinkMotion& is,
                         const LinkMotion& tracked) noexcept {
  const Vec3 turn = rotation_vector(tracked.X_W.q * is.X_W.q.conjugate());
  CoupledLink coupled;
  coupled.wrench.force = coupling.stiffness_N_m * (tracked.X_W.p - is.X_W.p) +
                         coupling.damping_N_s_m * (tracked.v_m_s - is.v_m_s);
  coupled.wrench.torque = coupling.stiffness_N_m_rad * turn +
                          coupling.damping_N_m_s_rad * (tracked.w_rad_s - is.w_rad_s);
  coupled.force_share = share_of(coupled.wrench.force.norm(), coupling.most_N);
  coupled.torque_share = share_of(coupled.wrench.torque.norm(), coupling.most_N_m);
  coupled.wrench.force *= coupled.force_share;
  coupled.wrench.torque *= coupled.torque_share;
  return coupled;
}

Wrench coupling_wrench(const LinkCoupling& coupling, const LinkMotion& is,
                       const LinkMotion& tracked) noexcept {
  return coupled_link(coupling, is, tracked).wrench;
}

}  // namespace isograsp::virtual_hand
