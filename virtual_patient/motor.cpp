// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/motor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isograsp {

namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;
constexpr double kWanderTime_s = 0.32;  ///< force wanders below 0.5 Hz = 1 / (2 pi 0.32 s)
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

}  // namespace

Motor::Motor(const PatientTraits& traits, std::uint64_t seed)
    : traits_(traits), random_(seed, 101) {
  take_away();
  for (auto& wander : wander_) wander = random_.gaussian();
  for (auto& phase : tremor_phase_rad_) phase = kTurn_rad * random_.uniform();
}

void Motor::take_away() noexcept {
  lag1_.fill(Vec3::Zero());
  lag2_.fill(Vec3::Zero());
}

void Motor::advance_noise(double dt_s) noexcept {
  // Ornstein-Uhlenbeck, exact for any step: the SD stays 1.
  const double keep = std::exp(-dt_s / kWanderTime_s);
  const double fresh = std::sqrt(1.0 - keep * keep);
  for (auto& wander : wander_) wander = keep * wander + fresh * random_.gaussian();
  for (auto& phase : tremor_phase_rad_)
    phase = std::fmod(phase + kTurn_rad * traits_.tremor_Hz * dt_s, kTurn_rad);
}

FingerWrenches Motor::step(const FingerForces& wanted, double dt_s) noexcept {
  FingerForces forces = enslaved(wanted, traits_.enslaving);
  const double approach = 1.0 - std::exp(-dt_s / traits_.muscle_lag_s);
  advance_noise(dt_s);
  FingerWrenches wrench_C;
  for (std::size_t f = 0; f < kFingerCount; ++f) {
    forces[f].z() = std::max(forces[f].z(), traits_.resting_force_N);
    const double size_N = forces[f].norm();
    if (size_N > traits_.maximum_force_N) forces[f] *= traits_.maximum_force_N / size_N;
    lag1_[f] += approach * (forces[f] - lag1_[f]);
    lag2_[f] += approach * (lag1_[f] - lag2_[f]);
    const double noise = 1.0 + traits_.force_cv * wander_[f] +
                         traits_.tremor_fraction * std::sin(tremor_phase_rad_[f]);
    wrench_C[f].force = std::max(noise, 0.0) * lag2_[f];
  }
  return wrench_C;
}

}  // namespace isograsp
