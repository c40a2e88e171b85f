// SPDX-License-Identifier: GPL-3.0-or-later
// The explicit steps of spin.hpp for four bodies at once, a body a lane: no lane crosses to
// another, so nothing is shuffled. The same bits as explicit_step(). Inside grasp_model/batch/
// only.
#pragma once

#include <array>

#include "grasp_model/angle_ratio.hpp"
#include "grasp_model/lanes.hpp"
#include "grasp_model/spin.hpp"

namespace isograsp::so3 {

/// Four without a massless axis, all with a spring or all without.
struct alignas(32) BodyRates {
  std::array<Four, 3> inertia, inverse_inertia, damping, gyroscopic;  ///< gyroscopic: I_k - I_j
  Four even_stiffness;
  std::array<Four, 3> stiffness_about;
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

/// Lanes that leave the way of angle_ratio() without transcendental functions.
[[gnu::noinline, gnu::cold]] inline void take_far_ratios(const Four& s2, const Four& w,
                                                         const LaneMask& near,
                                                         Four& ratio) noexcept {
  for (std::size_t i = 0; i < kLaneCount; ++i)
    if (near[i] == 0) ratio[i] = angle_ratio(s2[i], w[i]);
}
[[gnu::always_inline]] inline Four angle_ratios(const Four& s2, const Four& w) noexcept {
  Four inverse = 1.0 / w;
  const LaneMask near = (w > 0.0) & (s2 <= kAtanReach * (w * w));
  if (in_every_lane(near)) return 2.0 * inverse * atan_ratio<Four>(s2 * inverse * inverse);
  // Of the half angle.
  inverse = near ? inverse : 1.0 / (w + roots(s2 + w * w));
  const Four u = s2 * inverse * inverse;
  Four ratio = (near ? Four{} + 2.0 : Four{} + 4.0) * inverse * atan_ratio<Four>(u);
  const LaneMask half = near | ((w > 0.0) & (u <= kAtanReach));
  if (!in_every_lane(half)) [[unlikely]]
    take_far_ratios(s2, w, half, ratio);
  return ratio;
}

/// Of the turning bodies and their springs [J].
[[nodiscard, gnu::always_inline]] inline Four energies_of(const BodyRates& r,
                                                          const BodySpins& y) noexcept {
  Four twice_J =
      (r.inertia[0] * (y[4] * y[4]) + r.inertia[1] * (y[5] * y[5])) + r.inertia[2] * (y[6] * y[6]);
  if (r.spring) {
    const Four ratio = angle_ratios((y[1] * y[1] + y[2] * y[2]) + y[3] * y[3], y[0]);
    Four stretched{};
    for (std::size_t i = 0; i < 3; ++i) stretched += r.stiffness_about[i] * (y[i + 1] * y[i + 1]);
    twice_J += ratio * ratio * stretched;
  }
  return 0.5 * twice_J;
}
/// Those that may end a hold with more than they began with and `end`'s work: all that do, and
/// where rounding decides.
[[nodiscard, gnu::always_inline]] inline LaneMask may_gain_energy(const BodyRates& r,
                                                                  const BodySpins& start,
                                                                  const BodySpins& end) noexcept {
  constexpr double kRounding = 1e-12;  // of sums of some twenty numbers, and much more
  const Four before_J = energies_of(r, start);
  const Four after_J = energies_of(r, end);
  const Four work_J = end[7];
  const Four size_J = before_J + after_J + (work_J < 0.0 ? -work_J : work_J);
  return ~(after_J + kRounding * size_J <= before_J + work_J);
}

/// Real-time safe. `narrow`: without the wide registers of this
/// processor.
void explicit_steps(Order order, const BodyRates& rates, const BodyTorques& torques,
                    const BodySpins& start, const Four& h_s, BodySteps& out, bool narrow) noexcept;

}  // namespace isograsp::so3
