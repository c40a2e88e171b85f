// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/hand/seen_hand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isograsp::virtual_patient {

namespace {

Vec3 three_gaussian(Random& random) noexcept {
  const double x = random.gaussian();
  const double y = random.gaussian();
  return {x, y, random.gaussian()};
}

}  // namespace

// The second low-pass leaves half of the variance of the first, which is 1.
void SeenHand::Slow::begin(Random& random) noexcept {
  first = three_gaussian(random);
  second = std::sqrt(0.5) * three_gaussian(random);
}

void SeenHand::Slow::pass(double keep, Random& random) noexcept {
  first = keep * first + std::sqrt(1.0 - keep * keep) * three_gaussian(random);
  second = keep * second + (1.0 - keep) * first;
}

Vec3 SeenHand::Slow::value() const noexcept {
  return std::numbers::sqrt2 * second;
}

SeenHand::SeenHand(const GraspTraits& traits, std::uint64_t seed) noexcept
    : traits_(traits),
      wander_random_(seed, 221),
      noise_random_(seed, 222),
      loss_random_(seed, 223) {
  Random size_random(seed, 220);
  size_ = 1.0 + traits_.size_error * (2.0 * size_random.uniform() - 1.0);
  palm_.begin(wander_random_);
  for (Slow& tip : tips_) tip.begin(wander_random_);
}

HandFrame SeenHand::look(const std::array<Vec3, kHandJointCount>& joints_W, double dt_s) noexcept {
  const double keep = std::exp(-2.0 * std::numbers::pi * traits_.wander_Hz * dt_s);
  // rms length of a vector of three independent numbers
  const double each_m = traits_.wander_m / std::numbers::sqrt3;
  palm_.pass(keep, wander_random_);
  for (Slow& tip : tips_) tip.pass(keep, wander_random_);

  HandFrame seen;
  const Vec3 wrist = joints_W[kWristJoint];
  for (std::size_t j = 0; j < kHandJointCount; ++j)
    seen.joints[j] = wrist + size_ * (joints_W[j] - wrist) + each_m * palm_.value() +
                     traits_.tracker_m * three_gaussian(noise_random_);
  for (std::size_t d = 0; d < kDigitCount; ++d)
    for (std::size_t end = 1; end <= 3; ++end)
      seen.joints[joint_of(static_cast<Digit>(d), end)] +=
          static_cast<double>(end) / 3.0 * each_m * tips_[d].value();

  // Every draw is made whether it is needed or not: what is lost never changes the rest.
  const double chance = loss_random_.uniform();
  const double length_s =
      traits_.lost_least_s + (traits_.lost_most_s - traits_.lost_least_s) * loss_random_.uniform();
  const bool was_seen = lost_s_ == 0.0;  // between two losses there is a picture at least
  lost_s_ = std::max(0.0, lost_s_ - dt_s);
  const double mean_s = 0.5 * (traits_.lost_least_s + traits_.lost_most_s);
  const double per_s =
      mean_s > 0.0 ? traits_.lost_share / ((1.0 - traits_.lost_share) * mean_s) : 0.0;
  if (was_seen && chance < 1.0 - std::exp(-per_s * dt_s)) lost_s_ = length_s;
  seen.tracked = lost_s_ == 0.0;
  if (!seen.tracked) seen.joints.fill(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  return seen;
}

}  // namespace isograsp::virtual_patient
