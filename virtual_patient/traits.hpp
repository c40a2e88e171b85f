// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a person (docs/virtual_patient.md). A software test instrument, not data: every value
// of a shipped person is given with its source or called an assumption. The defaults below are
// those of a person without any of the troubles. SI units; shares are fractions.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>

#include "hand/finger.hpp"

namespace isograsp::virtual_patient {

struct PatientTraits {
  // Seeing and deciding
  double visual_delay_s = 0.18;
  double reaction_s = 0.25;         ///< from perceiving an instruction to acting
  double let_go_reaction_s = 0.25;  ///< the same before letting go
  double reaction_cv = 0.0;  ///< each reaction takes (1 + cv |g|) times as long, g standard normal
  double prediction = 0.8;   ///< share of their own delay that they foresee of a moving target
  double movement_s = 1.8;   ///< of one planned movement
  double missed_cue_probability = 0.0;
  double lapse_s = 4.0;  ///< a missed instruction is noticed this much later, if it still stands

  // Holding without seeing the own force
  double memory_cv = 0.0;      ///< SD of the level remembered / level
  double memory_loss = 0.0;    ///< share of the force that is lost in the end
  double memory_time_s = 5.0;  ///< time constant of error and loss

  // Strength
  double maximum_force_N = 60.0;   ///< of each digit, closing
  double opening_share = 0.4;      ///< of closing
  double sideways_share = 0.5;     ///< of closing
  double comfortable_share = 0.3;  ///< of the maximum
  double effort = 1.0;             ///< share of their maximum that they give
  double fatigue_per_s = 0.0;      ///< loss of strength at full force, share of what is left
  double recovery_s = 120.0;       ///< time constant of its return
  double pain_at = 2.0;            ///< share of the maximum above which it hurts; above 1: never
  double pain_after_s = 1.0;       ///< … for this long, then they stop

  // Directing
  double enslaving = 0.05;  ///< share of a digit's force that spreads to its neighbour
  double spreading = 0.0;   ///< is added to it at full effort
  std::array<double, kFingerCount> direction_error_rad{};  ///< of the intended force
  std::array<double, 3> arm_push{};  ///< net push on the platform / grip force, platform axes

  // Muscle
  double muscle_lag_s = 0.04;      ///< each of two first-order lags
  double release_s = 0.1;          ///< time constant of letting go
  double force_cv = 0.03;          ///< signal-dependent slow force noise, SD / mean
  double wander_s = 0.32;          ///< its time constant: below 1 / (2 pi 0.32 s) = 0.5 Hz
  double tremor_fraction = 0.005;  ///< amplitude / force
  double tremor_Hz = 9.0;
  double resting_force_N = 0.0;  ///< tone of each digit while relaxed
  double tone_rise = 0.0;        ///< share by which full effort raises it
  double tone_time_s = 3.0;      ///< time constant of rise and fall

  // Days
  double day_cv = 0.0;             ///< between-day SD / mean of the maximum and the tone
  double practice_gain = 0.0;      ///< share by which practice improves skill in the end
  double practice_sessions = 4.0;  ///< number of sessions to 63 % of it

  bool operator==(const PatientTraits&) const = default;
};

/// A trait that is one number: its place in a patient file and the values that make sense.
struct TraitField {
  std::string_view table;
  std::string_view key;
  double PatientTraits::*value;
  double least;
  double most;
};
[[nodiscard]] std::span<const TraitField> trait_fields() noexcept;
inline constexpr double kDegree_rad = std::numbers::pi / 180.0;
inline constexpr double kLargestDirectionError_deg = 90.0;
inline constexpr double kLargestArmPush = 1.0;
/// Every trait within its range.
[[nodiscard]] PatientTraits clamped(PatientTraits traits) noexcept;

/// The people who need no file: "healthy" | "paretic"; nullopt for any other name.
[[nodiscard]] std::optional<PatientTraits> patient_traits(std::string_view name);

/// A person on the way from `traits` (fraction 0) to healthy (fraction 1), every trait linearly.
[[nodiscard]] PatientTraits recovered(const PatientTraits& traits, double fraction);

/// After `sessions` sessions of practice: skill (foresight, steadiness, speed, memory) improves by
/// practice_gain (1 - exp(-sessions / practice_sessions)); strength and tone do not.
[[nodiscard]] PatientTraits practised(const PatientTraits& traits, double sessions);

/// The person as they are on one day: maximum, tone and release each times exp(cv g - cv^2 / 2), g
/// standard normal and independent, so that the mean over days is the trait. The between-day CV is
/// sqrt(exp(cv^2) - 1); at 20 % it agrees with cv to 1 %.
[[nodiscard]] PatientTraits on_day(const PatientTraits& traits, std::uint64_t day_seed);
/// The seed of a person's day.
[[nodiscard]] std::uint64_t day_seed(std::uint64_t person_seed, std::uint64_t day) noexcept;

}  // namespace isograsp::virtual_patient
