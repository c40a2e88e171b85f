// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/force_skill.hpp"

#include <algorithm>
#include <cmath>

#include "virtual_patient/loop_delay.hpp"

namespace isograsp::virtual_patient {

namespace {
constexpr double kCorrectionRate_per_s = 0.8;    ///< far below 1 / loop delay: a stable loop
constexpr double kLargestCorrectionShare = 0.2;  ///< of the largest force
constexpr double kSlopeTime_s = 0.1;
constexpr double kSuddenRate_per_s = 2.0;  ///< of the largest: a jump cannot be predicted
}  // namespace

FingerForces shared(ForceChannel channel, double force_N) noexcept {
  const Vec3 whole = force_N * axis_of(channel.direction);
  const Vec3 none = Vec3::Zero();
  switch (channel.digits) {
    case Digits::grip:
    case Digits::grip_mean: return {whole, 0.5 * whole, 0.5 * whole};
    case Digits::pinch: return {whole, whole, none};
    case Digits::sum: return {whole / 3.0, whole / 3.0, whole / 3.0};
    case Digits::thumb: return {whole, none, none};
    case Digits::index: return {none, whole, none};
    case Digits::middle: return {none, none, whole};
  }
  return {none, none, none};
}

double largest_force_N(const PatientTraits& traits, ForceChannel channel) noexcept {
  const double digits = channel.digits == Digits::sum ? 3.0 : 1.0;
  const double share = !is_normal(channel.direction)             ? traits.sideways_share
                       : channel.direction == Direction::minus_z ? traits.opening_share
                                                                 : 1.0;
  return digits * share * traits.maximum_force_N;
}

double least_jerk(double u) noexcept {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

void LevelMemory::begin(const PatientTraits& traits, Random& random) noexcept {
  error_ = traits.memory_cv * random.gaussian();
  loss_ = traits.memory_loss;
  time_s_ = traits.memory_time_s;
}

double LevelMemory::share(double held_s, bool at_once) const noexcept {
  const double grown = 1.0 - std::exp(-std::max(0.0, held_s) / time_s_);
  return std::max(0.0, 1.0 + error_ * (at_once ? 1.0 : grown) - loss_ * grown);
}

void ForceSkill::Moving::see(double next, double dt_s, double sudden) noexcept {
  if (dt_s > 0.0) {
    const double rate = (next - value) / dt_s;
    if (std::abs(rate) > sudden)
      slope = 0.0;
    else
      slope += std::min(1.0, dt_s / kSlopeTime_s) * (rate - slope);
  }
  value = next;
}

void ForceSkill::begin(ForceChannel channel, double lapse_s) noexcept {
  channel_ = channel;
  lapse_s_ = lapse_s;
  largest_N_ = largest_force_N(traits_, channel);
  seen_ = digits_seen_ = blind_ = blind_first_ = false;
  latest_s_ = 0.0;
  target_ = {};
  correction_N_ = 0.0;
  digit_shown_ = {};
  digits_ = {};
}

void ForceSkill::perceive(const Stimulus& picture, double t_s) noexcept {
  const bool any = picture.force_target_shown || picture.digit_targets.any();
  if (!any && !seen_) return;
  if (!picture.force_shown && !blind_) {
    blind_since_s_ = t_s;
    blind_first_ = !seen_;
    memory_.begin(traits_, random_);
  }
  blind_ = !picture.force_shown;
  if (!any) return;
  // The first pictures do not yet show what the person does.
  if (!seen_) answers_s_ = picture.t_s + lapse_s_ + 2.0 * loop_delay_s(traits_);
  const double dt_s = latest_s_ > 0.0 ? picture.t_s - latest_s_ : 0.0;
  if (picture.force_target_shown) perceive_target(picture, dt_s);
  if (picture.digit_targets.any()) perceive_digits(picture.digit_targets, dt_s);
  seen_ = true;
  latest_s_ = picture.t_s;
}

void ForceSkill::perceive_target(const Stimulus& picture, double dt_s) noexcept {
  if (seen_)
    target_.see(picture.target_force_N, dt_s, kSuddenRate_per_s * largest_N_);
  else
    target_.value = picture.target_force_N;
  if (picture.t_s <= answers_s_ || !picture.force_shown || dt_s <= 0.0) return;
  const double most_N = kLargestCorrectionShare * largest_N_;
  correction_N_ += kCorrectionRate_per_s * dt_s * (picture.target_force_N - picture.shown_force_N);
  correction_N_ = std::clamp(correction_N_, -most_N, most_N);
}

void ForceSkill::perceive_digits(const DigitTargets& targets, double dt_s) noexcept {
  digits_seen_ = true;
  digit_shown_ = targets.shown;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (!targets.shown[f]) {
      digits_[f] = {};
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      digits_[f][axis].see(targets.force_C[f][static_cast<Eigen::Index>(axis)], dt_s,
                           kSuddenRate_per_s * traits_.maximum_force_N);
  }
}

double ForceSkill::memory_share(double t_s) const noexcept {
  return blind_ ? memory_.share(t_s - blind_since_s_, blind_first_) : 1.0;
}

FingerForces ForceSkill::wanted(double t_s) const noexcept {
  const double ahead_s = traits_.prediction * loop_delay_s(traits_);
  const double share = memory_share(t_s);
  const double foreseen_N = target_.value + target_.slope * ahead_s;
  FingerForces forces = shared(channel_, share * std::max(0.0, foreseen_N + correction_N_));
  if (!digits_seen_) return forces;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    if (!digit_shown_[f]) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      forces[f][static_cast<Eigen::Index>(axis)] =
          share * (digits_[f][axis].value + digits_[f][axis].slope * ahead_s);
  }
  return forces;
}

}  // namespace isograsp::virtual_patient
