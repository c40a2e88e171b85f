// SPDX-License-Identifier: GPL-3.0-or-later
// What drags a link of the virtual hand to the tracked one: a spring and a damper of position and
// of attitude, whose force and torque saturate (Delrieu et al., coupling; docs/virtual_hand.md).
// World axes, SI units. Real-time safe.
#pragma once

#include "core/spatial.hpp"

namespace isograsp::virtual_hand {

/// One link, tracked or virtual, at the middle of its segment.
struct LinkMotion {
  Pose X_W;
  Vec3 v_m_s = Vec3::Zero();
  Vec3 w_rad_s = Vec3::Zero();
};

struct LinkCoupling {
  double stiffness_N_m = 300.0;
  double damping_N_s_m = 3.0;
  double most_N = 3.0;
  double stiffness_N_m_rad = 0.3;
  double damping_N_m_s_rad = 0.003;
  double most_N_m = 0.05;
};

/// Force and torque on the virtual link; each keeps its direction where it saturates.
struct CoupledLink {
  Wrench wrench;
  double force_share = 1.0;  ///< of what spring and damper ask for; 1: it does not saturate
  double torque_share = 1.0;
};
[[nodiscard]] CoupledLink coupled_link(const LinkCoupling& coupling, const LinkMotion& is,
                                       const LinkMotion& tracked) noexcept;
/// The wrench of coupled_link().
[[nodiscard]] Wrench coupling_wrench(const LinkCoupling& coupling, const LinkMotion& is,
                                     const LinkMotion& tracked) noexcept;

}  // namespace isograsp::virtual_hand
