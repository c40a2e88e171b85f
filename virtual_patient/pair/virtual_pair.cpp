// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/pair/virtual_pair.hpp"

#include <algorithm>
#include <cmath>

namespace isograsp::virtual_patient {

namespace {

constexpr double kSteps_Hz = 1000.0;
constexpr std::uint64_t kPairStream = 105;
constexpr std::uint64_t kRightSeed = 0x9E3779B97F4A7C15U;  // the right hand has noise of its own

/// The noise in common is made by the pair; the rest stays that of the hand. Variances add up.
PatientTraits without_common(PatientTraits traits, double common) {
  traits.force_cv *= std::sqrt(1.0 - common * common);
  return traits;
}

OfHands<double> shares_of(const OfHands<PatientTraits>& people, double exponent) {
  const double left = std::pow(people.left.maximum_force_N, exponent);
  const double right = std::pow(people.right.maximum_force_N, exponent);
  return {left / (left + right), right / (left + right)};
}

}  // namespace

VirtualPair::VirtualPair(const PairTraits& traits, const OfHands<PatientTraits>& people,
                         std::uint64_t seed)
    : traits_(traits),
      force_cv_{people.left.force_cv, people.right.force_cv},
      share_(shares_of(people, traits.share_exponent)),
      patients_{
          VirtualPatient(without_common(people.left, traits.common_noise), seed),
          VirtualPatient(without_common(people.right, traits.common_noise), seed ^ kRightSeed)},
      random_(seed, kPairStream),
      wander_(random_.gaussian()),
      wander_s_(std::max(people.left.wander_s, people.right.wander_s)),
      crosstalk_steps_(
          static_cast<std::size_t>(std::lround(traits.crosstalk_delay_s * kSteps_Hz))) {
  const bool left_is_weaker = people.left.maximum_force_N < people.right.maximum_force_N;
  (left_is_weaker ? lag_s_.left : lag_s_.right) = traits.lag_s;
  for (const Hand hand : kBothHands) {
    sides_[hand].belong_to(*this, hand);
    own_[hand].resize(kStored);
    pressed_[hand].resize(kStored);
  }
}

void VirtualPair::see(const Stimulus& stimulus) noexcept {
  for (const Hand hand : kBothHands) patients_[hand].see(picture_for(hand, stimulus));
  use_clutch();
}

void VirtualPair::meet_points(const OfHands<std::optional<CarryKnown>>& known) noexcept {
  for (const Hand hand : kBothHands) patients_[hand].meet_point(known[hand]);
  clutch_held_ = false;
}

void VirtualPair::use_clutch() noexcept {
  const OfHands<const CarrySkill*> of{patients_.left.carrying(), patients_.right.carrying()};
  if (of.left == nullptr || of.right == nullptr) return;
  if (clutch_held_) {
    clutch_held_ = !(of.left->relaxed() && of.right->relaxed());
    return;
  }
  const bool either = of.left->wants_clutch() || of.right->wants_clutch();
  bool all = true;
  for (const Hand hand : kBothHands) all = all && (of[hand]->wants_clutch() || of[hand]->waits());
  clutch_held_ = either && all;
}

void VirtualPair::meet_object(const OfHands<std::optional<Scene>>& halves) {
  for (const Hand hand : kBothHands) patients_[hand].meet_object(halves[hand]);
}

void VirtualPair::look_at_end(Hand hand, const ShownTray& tray, Stimulus& picture) noexcept {
  // Where the middle would be if the object were level.
  const Vec3& end_O = tray.end_O[hand];
  const Vec3 end_W = tray.X_WO.q * end_O;
  picture.object_shown = true;
  picture.X_WO = {tray.X_WO.p + end_W - end_O, Quat::Identity()};
  picture.v_WO_W = tray.v_WO_W + tray.w_WO_W.cross(end_W);
  picture.w_WO_W = Vec3::Zero();
  picture.pose_target_shown = tray.target_shown;
  picture.X_WT = {tray.X_WT.p, Quat::Identity()};
  picture.contact.fill(tray.touches[hand]);
}

Stimulus VirtualPair::picture_for(Hand hand, const Stimulus& whole) const noexcept {
  Stimulus picture = whole;
  picture.t_s += lag_s_[hand];
  if (!picture.hands || !picture.hands->carry) picture.hands.reset();
  // Outside of a trial, and in a pause, the cue is that of the page.
  if (!whole.hands || whole.cue == Cue::hand_out || whole.cue != whole.page_cue) return picture;
  const ShownHand& own = whole.hands->of[hand];
  const ShownHand& sum = whole.hands->sum;
  picture.cue = own.cue;
  picture.channel = {};
  if (whole.hands->tray) look_at_end(hand, *whole.hands->tray, picture);
  const bool by_itself = own.target_shown || !sum.target_shown;
  const double part = by_itself ? 1.0 : share_[hand];
  const ShownHand& watched = by_itself ? own : sum;
  picture.force_target_shown = watched.target_shown;
  picture.target_force_N = part * watched.target_force_N;
  picture.force_shown = watched.force_shown;
  picture.shown_force_N = part * watched.force_N;
  return picture;
}

FingerWrenches VirtualPair::press(Hand hand, std::size_t n, double t_s) noexcept {
  if (n >= steps_) advance(t_s);
  return pressed_[hand][n % kStored];
}

void VirtualPair::advance(double t_s) noexcept {
  const double dt_s = std::max(0.0, t_s - latest_s_);
  latest_s_ = t_s;
  const double keep = std::exp(-dt_s / wander_s_);  // Ornstein-Uhlenbeck, exact for any step
  wander_ = keep * wander_ + std::sqrt(1.0 - keep * keep) * random_.gaussian();
  const std::size_t now = steps_ % kStored;
  for (const Hand hand : kBothHands) {
    const double noise = std::max(0.0, 1.0 + traits_.common_noise * force_cv_[hand] * wander_);
    own_[hand][now] = patients_[hand].press(t_s);
    for (Wrench& wrench : own_[hand][now]) {
      wrench.force *= noise;
      wrench.torque *= noise;
    }
  }
  for (const Hand hand : kBothHands) {
    FingerWrenches& pressed = pressed_[hand][now];
    pressed = own_[hand][now];
    if (steps_ < crosstalk_steps_) continue;
    const FingerWrenches& other = own_[other_than(hand)][(steps_ - crosstalk_steps_) % kStored];
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      pressed[f].force += traits_.crosstalk * other[f].force;
      pressed[f].torque += traits_.crosstalk * other[f].torque;
    }
  }
  ++steps_;
}

}  // namespace isograsp::virtual_patient
