// SPDX-License-Identifier: GPL-3.0-or-later
// How a person makes one force of a channel: shares it among the digits and follows a target on the
// screen, which is seen late. A force that is not on the screen is held from memory. Contact
// frames; SI units.
#pragma once

#include "core/random.hpp"
#include "hand/stimulus.hpp"
#include "virtual_patient/motor.hpp"
#include "virtual_patient/traits.hpp"

namespace isograsp::virtual_patient {

/// How a person shares `force_N` of a channel among the digits: the thumb against both fingers
/// equally, a sum in three equal parts. The channel's force of the result is `force_N`.
[[nodiscard]] FingerForces shared(ForceChannel channel, double force_N) noexcept;
/// The largest force of a channel that a rested person can make [N].
[[nodiscard]] double largest_force_N(const PatientTraits& traits, ForceChannel channel) noexcept;
/// A rise from 0 to 1 with least jerk (Flash, Hogan 1985), at the share u of its time; 0 before, 1
/// after.
[[nodiscard]] double least_jerk(double u) noexcept;

/// What becomes of a force level that is not seen: (1 + error) - loss, growing with time.
class LevelMemory {
 public:
  /// Remembers a level anew; the error is drawn now.
  void begin(const PatientTraits& traits, Random& random) noexcept;
  /// Held / remembered, `held_s` after vision was lost. `at_once`: the level is made from memory,
  /// so its error is there from the start; else it grows.
  [[nodiscard]] double share(double held_s, bool at_once) const noexcept;

 private:
  double error_ = 0.0;
  double loss_ = 0.0;
  double time_s_ = 1.0;
};

/// Follows a force target, or one per digit.
class ForceSkill {
 public:
  ForceSkill(const PatientTraits& traits, std::uint64_t seed)
      : traits_(traits), random_(seed, 103) {}

  /// Begins anew: nothing seen, nothing learned. The person will act `lapse_s` later than usual.
  void begin(ForceChannel channel, double lapse_s) noexcept;
  /// A perceived picture, in the order of time, at time t_s of the person. Real-time safe.
  void perceive(const Stimulus& picture, double t_s) noexcept;
  /// The forces wanted at time t_s. Real-time safe.
  [[nodiscard]] FingerForces wanted(double t_s) const noexcept;

 private:
  /// A number that moves, predicted by its smoothed slope.
  struct Moving {
    double value = 0.0;
    double slope = 0.0;  ///< [1/s]
    void see(double next, double dt_s, double sudden) noexcept;
  };
  void perceive_target(const Stimulus& picture, double dt_s) noexcept;
  void perceive_digits(const DigitTargets& targets, double dt_s) noexcept;
  [[nodiscard]] double memory_share(double t_s) const noexcept;

  PatientTraits traits_;
  Random random_;
  ForceChannel channel_;
  double largest_N_ = 0.0;
  double lapse_s_ = 0.0;
  bool seen_ = false;
  double answers_s_ = 0.0;  ///< pictures later than this show what the person does
  double latest_s_ = 0.0;
  Moving target_;              ///< [N]
  double correction_N_ = 0.0;  ///< integral of the seen error

  bool digits_seen_ = false;
  std::array<bool, kFingerCount> digit_shown_{};
  std::array<std::array<Moving, 3>, kFingerCount> digits_{};  ///< [N]

  bool blind_ = false;        ///< the own force is not on the screen
  bool blind_first_ = false;  ///< … and never was
  double blind_since_s_ = 0.0;
  LevelMemory memory_;
};

}  // namespace isograsp::virtual_patient
