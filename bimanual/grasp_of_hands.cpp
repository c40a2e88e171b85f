// SPDX-License-Identifier: GPL-3.0-or-later
#include "bimanual/grasp_of_hands.hpp"

#include "bimanual/clip.hpp"

namespace isograsp::bimanual {

bool GraspOfHands::see(const std::array<Vec3, kSides>& p_W,
                       const std::array<Vec3, kSides>& push_W_N, const Pose& X_WO) noexcept {
  constexpr double kOpened = 4.0;  // times the reach, beyond the chord: the hands let go
  constexpr double kLetGo = 0.5;   // of the force that holds
  const Vec3 line = p_W[1] - p_W[0];
  const double apart_m = line.norm();
  if (!(apart_m > 0.0)) {
    squeeze_N_ = {};
    return holds_ = false;
  }
  squeeze_N_ = {push_W_N[0].dot(line) / apart_m, -push_W_N[1].dot(line) / apart_m};
  const auto both_above = [&](double share) {
    return squeeze_N_[0] > share * rule_.force_on_N[0] &&
           squeeze_N_[1] > share * rule_.force_on_N[1];
  };
  if (holds_) return holds_ = both_above(kLetGo) && apart_m - chord_m_ <= kOpened * rule_.reach_m;
  if (!both_above(1.0)) return false;
  const std::array<Vec3, kSides> p_O{X_WO.q.conjugate() * (p_W[0] - X_WO.p),
                                     X_WO.q.conjugate() * (p_W[1] - X_WO.p)};
  const auto part = clip(shape_, size_m_, p_O[0], p_O[1]);
  if (!part) return false;
  const double chord_m = (part->to - part->from) * apart_m;
  if (chord_m < rule_.least_chord_m || part->from * apart_m > rule_.reach_m ||
      (1.0 - part->to) * apart_m > rule_.reach_m)
    return false;
  chord_m_ = chord_m;
  anchor_O_ = {p_O[0] + part->from * (p_O[1] - p_O[0]), p_O[0] + part->to * (p_O[1] - p_O[0])};
  return holds_ = true;
}

}  // namespace isograsp::bimanual
