// SPDX-License-Identifier: GPL-3.0-or-later
#include "hand_world/tracked_target.hpp"

#include <algorithm>

#include "grasp_model/rotation.hpp"
#include "virtual_hand/hand_frame.hpp"

namespace isograsp::hand_world {

namespace {

using virtual_hand::LinkMotion;

Vec3 no_more_than(const Vec3& value, double most) noexcept {
  const double size = value.norm();
  return size > most ? Vec3(value * (most / size)) : value;
}

LinkMotion between_motions(const LinkMotion& from, const LinkMotion& to, double share,
                           double span_s) noexcept {
  Quat turn = to.X_W.q * from.X_W.q.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Vec3 angle = so3::log(turn);
  const Vec3 way = to.X_W.p - from.X_W.p;
  LinkMotion now;
  now.X_W = {from.X_W.p + share * way, (so3::exp(share * angle) * from.X_W.q).normalized()};
  now.v_m_s = no_more_than(way / span_s, kMostTracked_m_s);
  now.w_rad_s = no_more_than(angle / span_s, kMostTracked_rad_s);
  return now;
}

}  // namespace

std::optional<HandTarget> target_of_frame(const virtual_hand::HandModel& model,
                                          const HandFrame& frame) noexcept {
  const auto fitted = virtual_hand::fitted_pose(model, frame);
  if (!fitted) return std::nullopt;
  const virtual_hand::HandInSpace hand = virtual_hand::hand_in_space(model, fitted->pose);
  HandTarget target = still_target(hand);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k) {
      const auto digit = static_cast<Digit>(d);
      const Vec3& begins = frame.joints[joint_of(digit, k)];
      const Vec3& ends = frame.joints[joint_of(digit, k + 1)];
      Pose& X_W = target.links[d][k].X_W;
      X_W.p = 0.5 * (begins + ends);
      const Vec3 along = ends - begins;
      if (!(along.norm() > 0.0)) continue;
      const Vec3 fits = X_W.q * -Vec3::UnitZ();
      X_W.q = (so3::shortest(fits, along) * X_W.q).normalized();
    }
  return target;
}

HandTarget between_targets(const HandTarget& from, const HandTarget& to, double share,
                           double span_s) noexcept {
  HandTarget now;
  now.palm = between_motions(from.palm, to.palm, share, span_s);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      now.links[d][k] = between_motions(from.links[d][k], to.links[d][k], share, span_s);
  return now;
}

double furthest(const HandTarget& from, const HandTarget& to) noexcept {
  double most_m = (to.palm.X_W.p - from.palm.X_W.p).norm();
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      most_m = std::max(most_m, (to.links[d][k].X_W.p - from.links[d][k].X_W.p).norm());
  return most_m;
}

}  // namespace isograsp::hand_world
