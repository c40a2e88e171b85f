// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/carry_skill.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isograsp::virtual_patient {

namespace {

constexpr double kSqueeze = 0.5;  // of the force at the edge, where the point touches
constexpr double kMostSqueeze = 0.6;
constexpr double kFirmest = 0.85;
constexpr double kTrailing = 0.45;  // what a hand keeps that gives way
constexpr double kFar = 0.35;       // of the bubble: further away the bubble itself has to go …
constexpr double kNear = 0.18;      // … until it is so near: who relaxes then moves little
constexpr double kMostInBubble = 0.85;  // of what is reached without moving it
constexpr double kApproach_s = 1.3;     // at its speed of now: slower than seeing
constexpr double kMostExcess = 0.8;     // of the force at the edge, beyond it
constexpr double kSmooth_s = 0.12;
constexpr double kBeside_m = 0.018;    // along the line of the hands, so near is beside the box …
constexpr double kLevel_m = 0.012;     // … and so near is level with it
constexpr double kAstray = 1.6;        // … and so many times as far it is no more
constexpr double kStretched_s = 0.7;   // pushing so long brings the point where it goes
constexpr double kStands = 0.12;       // an aim that changes less stands
constexpr double kLeastWay_m = 0.006;  // so fast a bubble goes the last of its way
constexpr double kInside_m = 0.004;    // a point that squeezes is a little inside

}  // namespace

CarrySkill::CarrySkill(const PatientTraits& traits, const CarryKnown& known) noexcept
    : known_(known), tone_N_(traits.resting_force_N * (1.0 + traits.tone_rise)) {}

void CarrySkill::begin(double t_s) noexcept {
  closing_ = stretched_ = waits_ = relaxed_ = far_ = false;
  aim_.setZero();
  push_.setZero();
  pushed_s_ = still_s_ = seen_s_ = t_s;
}

double CarrySkill::excess_for(double way_m) const noexcept {
  const double speed_m_s = std::max(0.0, way_m) / kApproach_s;
  return std::min(std::pow(speed_m_s / known_.rate_m_s, 1.0 / known_.rate_exponent), kMostExcess);
}

Vec3 CarrySkill::toward(const Vec3& way_m, const Vec3& half_size_m, double squeeze) noexcept {
  const Vec3 q = way_m.cwiseQuotient(half_size_m);
  const double rho = q.norm();
  const bool was_far = std::exchange(far_, false);
  if (rho == 0.0) return q;
  // Who pushes beside the squeeze reaches the edge of the bubble with less: that far in the
  // direction of `way_m`, for an excess e.
  const Vec3 along = q / rho;
  const double across = squeeze * std::abs(along.x());
  const auto reach = [&](double e) {
    return std::sqrt(across * across - squeeze * squeeze + (1.0 + e) * (1.0 + e)) - across;
  };
  far_ = rho > (was_far ? kNear : kFar);
  if (!far_) return q;
  if (known_.clutch) return std::min(rho, kMostInBubble * reach(0.0)) * along;
  return reach(excess_for(std::max(rho * half_size_m.minCoeff(), kLeastWay_m))) * along;
}

/// Brings the bubble beside the object; squeezes as soon as both are there.
Vec3 CarrySkill::free_hand(const ShownCarry& seen) noexcept {
  const Vec3& a = seen.half_size_m;
  const double half_m = seen.size_m.x() / 2.0;
  const double allowed = closing_ ? kAstray : 1.0;
  closing_ = true;
  Vec3 way = Vec3::Zero();
  for (const Hand hand : kBothHands) {
    const double sign = hand == Hand::left ? -1.0 : 1.0;
    Vec3 beside = seen.X_WO.p;
    beside.x() += sign * (half_m + kSqueeze * a.x());
    const Vec3 left = beside - seen.of[hand].bubble_W;
    const bool there =
        std::abs(left.x()) <= allowed * kBeside_m && std::abs(left.y()) <= allowed * kLevel_m;
    closing_ = closing_ && there;
    if (hand != known_.hand) continue;
    way = left;
    waits_ = there;
  }
  if (!closing_) {
    if (waits_) return Vec3::Zero();
    // The bubble itself is to go there, however near it is.
    far_ = true;
    const Vec3 q = way.cwiseQuotient(a);
    if (known_.clutch) return q / std::max(q.norm(), 1.0);
    return (1.0 + excess_for(std::max(way.norm(), kLeastWay_m))) / q.norm() * q;
  }
  Vec3 point = seen.X_WO.p;
  point.x() += side() * (half_m - (known_.pinch ? kInside_m : known_.depth_m));
  Vec3 q = (point - seen.of[known_.hand].bubble_W).cwiseQuotient(a);
  q.x() = -side() * std::clamp(-side() * q.x(), kTrailing, kFirmest);
  q.y() = std::clamp(q.y(), -0.4, 0.4);
  return q;
}

/// What is held goes with the middle of both points; both keep squeezing.
Vec3 CarrySkill::pinching_hand(const ShownCarry& seen) noexcept {
  const Vec3& a = seen.half_size_m;
  Vec3 common = Vec3::Zero();  // of both points from the middles of their bubbles
  for (const Hand hand : kBothHands) common += 0.5 * (seen.of[hand].p_W - seen.of[hand].bubble_W);
  const Vec3 way = seen.X_WT.p - seen.X_WO.p + common;
  // Where the box would be if nobody pushed it aside.
  const double middle_m = seen.X_WO.p.x() - common.x();
  const double apart_m = side() * (seen.of[known_.hand].bubble_W.x() - middle_m);
  const double face_m = seen.size_m.x() / 2.0 - kInside_m;
  const double squeeze = std::clamp((apart_m - face_m) / a.x(), kSqueeze, kMostSqueeze);
  Vec3 q = toward(way, a, squeeze);
  if (seen.clutch) q.setZero();
  // The hand that gives way keeps a hold, the other one pushes as much more.
  q.x() = -side() * std::max(squeeze - side() * q.x(), kTrailing);
  return q;
}

/// Both points go as the object is to go, each a little inside it.
Vec3 CarrySkill::pressing_hand(const ShownCarry& seen) noexcept {
  constexpr double kAhead_m = 0.04;
  constexpr double kGivesWay = 0.15;
  Vec3 way = seen.X_WT.p - seen.X_WO.p;
  if (const double far_m = way.norm(); far_m > kAhead_m) way *= kAhead_m / far_m;
  // The hand that the box comes to gives way as it comes.
  if (side() * way.x() > 0.0) way.x() *= kGivesWay;
  Vec3 point = seen.X_WO.p + way;
  point.x() += side() * (seen.size_m.x() / 2.0 - known_.depth_m);
  const Vec3& a = seen.half_size_m;
  Vec3 left = point - seen.of[known_.hand].bubble_W;
  // What has slipped between the pads stays where it is between them.
  left.y() = seen.of[known_.hand].p_W.y() - seen.of[known_.hand].bubble_W.y() + way.y();
  // The squeeze comes first; what is left of the bubble is for the way up or down.
  const double squeeze = std::clamp(-side() * left.x() / a.x(), -kMostInBubble, kMostInBubble);
  Vec3 q = toward(Vec3(0.0, left.y(), 0.0), a, squeeze);
  q.x() = -side() * squeeze;
  // While the bubble comes along only the squeeze stays.
  if (seen.clutch) q = Vec3(-side() * known_.depth_m / a.x(), 0.0, 0.0);
  return q;
}

void CarrySkill::perceive(const Stimulus& picture, double t_s) noexcept {
  if (!picture.hands || !picture.hands->carry || !picture.hands->carry->target_shown) {
    stretched_ = waits_ = false;
    relaxed_ = true;
    return;
  }
  const ShownCarry& seen = *picture.hands->carry;
  waits_ = false;
  Vec3 aim = !seen.held     ? free_hand(seen)
             : known_.pinch ? pinching_hand(seen)
                            : pressing_hand(seen);
  aim.z() = 0.0;
  if (seen.held) closing_ = false;
  if (seen.clutch && !seen.held) aim.setZero();
  if ((aim - aim_).norm() > kStands) still_s_ = t_s;
  aim_ = aim;
  seen_s_ = t_s;
  const bool stood = t_s - still_s_ > kStretched_s;
  stretched_ = known_.clutch && !seen.clutch && far_ && stood && !waits_;
  relaxed_ = seen.clutch && stood;
}

FingerForces CarrySkill::wanted(double t_s) noexcept {
  const double dt_s = std::max(0.0, t_s - pushed_s_);
  pushed_s_ = t_s;
  push_ += (1.0 - std::exp(-dt_s / kSmooth_s)) * (aim_ - push_);
  const Vec3 push_N = known_.at_edge_N * push_;
  FingerForces forces;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    forces[f] = known_.R_WC[f].transpose() * push_N / static_cast<double>(kFingerCount);
  // A grip that keeps each digit pressing by more than its tone, which would else push the hand
  // away; the thumb faces both fingers, so the grip itself pushes nowhere.
  const double grip_N = std::max({0.0, tone_N_ - forces[0].z(), 2.0 * (tone_N_ - forces[1].z()),
                                  2.0 * (tone_N_ - forces[2].z())});
  forces[0].z() += grip_N;
  forces[1].z() += 0.5 * grip_N;
  forces[2].z() += 0.5 * grip_N;
  return forces;
}

}  // namespace isograsp::virtual_patient
