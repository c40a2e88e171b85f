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

LinkMotion between_frames(const LinkMotion& from, const LinkMotion& to, double share,
                          double span_s) noexcept {
  Quat turn = to.X_W.q * from.X_W.q.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const Vec3 angle = so3::log(turn);
  const Vec3 way = to.X_W.p - from.X_W.p;
  LinkMotion now;
  now.X_W = {from.X_W.p + share * way, (so3::exp(share * angle) * from.X_W.q).normalized()};
  now.v_m_s = no_more_than(way / span_s, TrackedTarget::kMost_m_s);
  now.w_rad_s = no_more_than(angle / span_s, TrackedTarget::kMost_rad_s);
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
      X_W.q = (Quat::FromTwoVectors(fits, along) * X_W.q).normalized();
    }
  return target;
}

bool TrackedTarget::add(double t_s, const HandTarget& target) noexcept {
  if (count_ > 0 && !(t_s > frames_[count_ - 1].t_s)) return false;
  if (count_ == kKept) {
    std::rotate(frames_.begin(), frames_.begin() + 1, frames_.end());
    --count_;
  }
  frames_[count_++] = {t_s, target};
  return true;
}

std::optional<HandTarget> TrackedTarget::at(double t_s) const noexcept {
  if (count_ == 0) return std::nullopt;
  const double late_s = t_s - period_s_;
  if (late_s <= frames_[0].t_s) return frames_[0].target;
  std::size_t next = 1;
  while (next < count_ && frames_[next].t_s <= late_s) ++next;
  if (next == count_) return frames_[count_ - 1].target;
  const Frame& from = frames_[next - 1];
  const Frame& to = frames_[next];
  const double span_s = to.t_s - from.t_s;
  const double share = (late_s - from.t_s) / span_s;
  HandTarget now;
  now.palm = between_frames(from.target.palm, to.target.palm, share, span_s);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t k = 0; k < kLinkCount; ++k)
      now.links[d][k] =
          between_frames(from.target.links[d][k], to.target.links[d][k], share, span_s);
  return now;
}

}  // namespace isograsp::hand_world
