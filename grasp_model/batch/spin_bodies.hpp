// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit steps of spin.hpp for four bodies at once, a body a lane: no lane crosses to
// another, so nothing is shuffled. The same bits as explicit_step(). Inside grasp_model/batch/
// only.
#pragma once

#include <array>

#include "grasp_model/lanes.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp::so3 {

/// Four without a massless axis, all with a spring or all without.
struct alignas(32) BodyRates {
  std::array<Four, 3> inverse_inertia, damping, gyroscopic;  ///< gyroscopic: I_k - I_j
  Four even_stiffness;
  std::array<Vec3, kLaneCount> stiffness;  ///< by body
  bool spring = false;
  bool even_spring = false;  ///< each body has one stiffness about all axes: even_stiffness
};
/// What a hold does to them; as Torques.
struct alignas(32) BodyTorques {
  std::array<Four, 3> world{}, body{};
  LaneMask has_world{};  ///< that in world axes is not zero
  LaneMask watched{};    ///< SpinRate::watched()
};

/// A SpinVector of each: w x y z, angular velocity, work.
using BodySpins = std::array<Four, 8>;

/// As SpinStep.
struct alignas(32) BodySteps {
  BodySpins end;
  Four error_rad, coarser_rad;
};

/// Real-time safe. `narrow`: without the wide registers of this
/// processor.
void explicit_steps(Order order, const BodyRates& rates, const BodyTorques& torques,
                    const BodySpins& start, const Four& h_s, BodySteps& out, bool narrow) noexcept;

}  // namespace isograsp::so3
