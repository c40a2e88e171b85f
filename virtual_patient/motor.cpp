// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/motor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace isograsp::virtual_patient {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
/// The thumb is coupled to the fingers this much less than they are to each other.
constexpr double kThumbCoupling = 0.2;

/// Every digit takes a share of the mean of its neighbours; a force common to all stays as wanted,
/// because people have learned what their hand does together.
FingerForces enslaved(const FingerForces& wanted, double share) noexcept {
  const auto mix = [](const Vec3& own, const Vec3& other, double weight) -> Vec3 {
    return (own + weight * other) / (1.0 + weight);
  };
  const auto& [thumb, index, middle] = wanted;
  FingerForces forces{thumb, mix(index, middle, share), mix(middle, index, share)};
  forces[0].z() = mix(thumb, index + middle, kThumbCoupling * share).z();
  return forces;
}

/// A push in platform axes (x from the thumb to the fingers, z up) in the contact frame of a digit:
/// thumb z = x, fingers z = -x, all x = y.
Vec3 in_contact(const std::array<double, 3>& push_P, std::size_t finger) noexcept {
  const double side = finger == index_of(Finger::thumb) ? 1.0 : -1.0;
  return {push_P[1], side * push_P[2], side * push_P[0]};
}

}  // namespace

double strength_used(const PatientTraits& traits, const Vec3& force_C) noexcept {
  const double normal = force_C.z() < 0.0 ? traits.opening_share : 1.0;
  return std::hypot(force_C.x() / traits.sideways_share, force_C.y() / traits.sideways_share,
                    force_C.z() / normal) /
         traits.maximum_force_N;
}

Vec3 misdirected(const Vec3& force_C, double angle_rad) noexcept {
  const Vec3 drift = (Vec3::UnitX() + Vec3::UnitZ()) / std::numbers::sqrt2;
  const Vec3 axis = force_C.cross(drift);
  const double across = axis.norm();
  const double size = force_C.norm();
  constexpr double kAlongTheDrift = 1e-9;  // along the drift: nothing to turn
  if (angle_rad <= 0.0 || across <= kAlongTheDrift * size) return force_C;
  const double turn_rad = std::min(angle_rad, std::atan2(across, force_C.dot(drift)));
  return std::cos(turn_rad) * force_C + std::sin(turn_rad) * (axis / across).cross(force_C);
}

Motor::Motor(const PatientTraits& traits, std::uint64_t seed)
    : traits_(traits), random_(seed, 101) {
  take_away(0.0);
  for (auto& wander : wander_) wander = random_.gaussian();
  for (auto& phase : tremor_phase_rad_) phase = kTurn_rad * random_.uniform();
}

void Motor::take_away(double dt_s) noexcept {
  lag1_.fill(Vec3::Zero());
  lag2_.fill(Vec3::Zero());
  advance_state(0.0, dt_s);
}

void Motor::advance_noise(double dt_s) noexcept {
  // Ornstein-Uhlenbeck, exact for any step: the SD stays 1.
  const double keep = std::exp(-dt_s / traits_.wander_s);
  const double fresh = std::sqrt(1.0 - keep * keep);
  for (auto& wander : wander_) wander = keep * wander + fresh * random_.gaussian();
  for (auto& phase : tremor_phase_rad_)
    phase = std::fmod(phase + kTurn_rad * traits_.tremor_Hz * dt_s, kTurn_rad);
}

void Motor::advance_state(double effort, double dt_s) noexcept {
  tone_ += (1.0 - std::exp(-dt_s / traits_.tone_time_s)) * (effort - tone_);
  // d/dt fatigue = rate * force / maximum * what is left - fatigue / recovery, exact for one step.
  const double tiring_per_s = traits_.fatigue_per_s * effort;
  const double rate_per_s = tiring_per_s + 1.0 / traits_.recovery_s;
  fatigue_ += (1.0 - std::exp(-rate_per_s * dt_s)) * (tiring_per_s / rate_per_s - fatigue_);
}

void Motor::limit(Vec3& force_C) const noexcept {
  const double used = strength_used(traits_, force_C);
  if (used > freshness()) force_C *= freshness() / used;
}

FingerWrenches Motor::step(const FingerForces& wanted, double dt_s) noexcept {
  double effort = 0.0;  // of the busiest digit
  double grip_N = 0.0;
  FingerForces intended;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    effort = std::max(effort, std::min(strength_used(traits_, wanted[f]), freshness()));
    grip_N += 0.5 * wanted[f].norm();
    intended[f] = misdirected(wanted[f], traits_.direction_error_rad[f]);
  }
  FingerForces forces = enslaved(intended, traits_.enslaving + traits_.spreading * effort);
  advance_noise(dt_s);
  advance_state(effort, dt_s);
  const double approach = 1.0 - std::exp(-dt_s / traits_.muscle_lag_s);
  const double tone_N = traits_.resting_force_N * (1.0 + traits_.tone_rise * tone_);
  const double push_N = grip_N / static_cast<double>(kFingerCount);
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    const bool opening = forces[f].z() < 0.0;
    forces[f] += push_N * in_contact(traits_.arm_push, f);
    forces[f].z() = opening ? forces[f].z() + tone_N : std::max(forces[f].z(), tone_N);
    limit(forces[f]);
    lag1_[f] += approach * (forces[f] - lag1_[f]);
    lag2_[f] += approach * (lag1_[f] - lag2_[f]);
    const double noise = 1.0 + traits_.force_cv * wander_[f] +
                         traits_.tremor_fraction * std::sin(tremor_phase_rad_[f]);
    wrench_C[f].force = std::max(noise, 0.0) * lag2_[f];
    limit(wrench_C[f].force);
  }
  return wrench_C;
}

}  // namespace isograsp::virtual_patient
