// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/traits.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace isograsp::virtual_patient {

namespace {

using T = PatientTraits;

// The ranges find mistakes (milliseconds for seconds, percent for shares), not unusual people.
constexpr std::array kFields{
    TraitField{"senses", "visual_delay_s", &T::visual_delay_s, 0.02, 0.9},
    TraitField{"senses", "reaction_s", &T::reaction_s, 0.05, 5.0},
    TraitField{"senses", "let_go_reaction_s", &T::let_go_reaction_s, 0.05, 10.0},
    TraitField{"senses", "reaction_cv", &T::reaction_cv, 0.0, 1.0},
    TraitField{"senses", "prediction", &T::prediction, 0.0, 1.0},
    TraitField{"senses", "movement_s", &T::movement_s, 0.3, 20.0},
    TraitField{"senses", "missed_cue_probability", &T::missed_cue_probability, 0.0, 1.0},
    TraitField{"senses", "lapse_s", &T::lapse_s, 0.0, 60.0},
    TraitField{"memory", "memory_cv", &T::memory_cv, 0.0, 1.0},
    TraitField{"memory", "memory_loss", &T::memory_loss, 0.0, 1.0},
    TraitField{"memory", "memory_time_s", &T::memory_time_s, 0.5, 120.0},
    TraitField{"strength", "maximum_force_N", &T::maximum_force_N, 0.5, 300.0},
    TraitField{"strength", "opening_share", &T::opening_share, 0.01, 1.0},
    TraitField{"strength", "sideways_share", &T::sideways_share, 0.05, 1.0},
    TraitField{"strength", "comfortable_share", &T::comfortable_share, 0.01, 1.0},
    TraitField{"strength", "effort", &T::effort, 0.05, 1.0},
    TraitField{"strength", "fatigue_per_s", &T::fatigue_per_s, 0.0, 0.2},
    TraitField{"strength", "recovery_s", &T::recovery_s, 5.0, 3600.0},
    TraitField{"strength", "pain_at", &T::pain_at, 0.02, 2.0},
    TraitField{"strength", "pain_after_s", &T::pain_after_s, 0.0, 60.0},
    TraitField{"direction", "enslaving", &T::enslaving, 0.0, 2.0},
    TraitField{"direction", "spreading", &T::spreading, 0.0, 3.0},
    TraitField{"muscle", "muscle_lag_s", &T::muscle_lag_s, 0.005, 1.0},
    TraitField{"muscle", "release_s", &T::release_s, 0.02, 20.0},
    TraitField{"muscle", "force_cv", &T::force_cv, 0.0, 0.5},
    TraitField{"muscle", "wander_s", &T::wander_s, 0.05, 10.0},
    TraitField{"muscle", "tremor_fraction", &T::tremor_fraction, 0.0, 0.5},
    TraitField{"muscle", "tremor_Hz", &T::tremor_Hz, 1.0, 15.0},
    TraitField{"muscle", "resting_force_N", &T::resting_force_N, 0.0, 20.0},
    TraitField{"muscle", "tone_rise", &T::tone_rise, 0.0, 5.0},
    TraitField{"muscle", "tone_time_s", &T::tone_time_s, 0.2, 60.0},
    TraitField{"days", "day_cv", &T::day_cv, 0.0, 0.5},
    TraitField{"days", "practice_gain", &T::practice_gain, 0.0, 0.9},
    TraitField{"days", "practice_sessions", &T::practice_sessions, 0.5, 100.0},
};

}  // namespace

std::span<const TraitField> trait_fields() noexcept {
  return kFields;
}

PatientTraits clamped(PatientTraits traits) noexcept {
  for (const TraitField& field : kFields)
    traits.*field.value = std::clamp(traits.*field.value, field.least, field.most);
  for (double& error_rad : traits.direction_error_rad)
    error_rad = std::clamp(error_rad, 0.0, kLargestDirectionError_deg * kDegree_rad);
  for (double& push : traits.arm_push) push = std::clamp(push, -kLargestArmPush, kLargestArmPush);
  return traits;
}

std::optional<PatientTraits> patient_traits(std::string_view name) {
  PatientTraits traits;
  if (name == "healthy") {
    traits.resting_force_N = 0.1;
    return traits;
  }
  if (name != "paretic") return std::nullopt;
  traits.visual_delay_s = 0.28;
  traits.reaction_s = 0.45;
  traits.let_go_reaction_s = 0.45;
  traits.movement_s = 3.5;
  traits.maximum_force_N = 12.0;
  traits.enslaving = 0.30;
  traits.muscle_lag_s = 0.08;
  traits.force_cv = 0.05;
  traits.tremor_fraction = 0.015;
  traits.tremor_Hz = 6.0;
  traits.resting_force_N = 0.3;
  traits.release_s = 0.6;
  traits.prediction = 0.4;
  return traits;
}

PatientTraits recovered(const PatientTraits& traits, double fraction) {
  const PatientTraits healthy = *patient_traits("healthy");
  PatientTraits on_the_way = traits;
  for (const TraitField& field : kFields)
    on_the_way.*field.value += fraction * (healthy.*field.value - traits.*field.value);
  for (std::size_t i = 0; i < kFingerCount; ++i)
    on_the_way.direction_error_rad[i] +=
        fraction * (healthy.direction_error_rad[i] - traits.direction_error_rad[i]);
  for (std::size_t i = 0; i < traits.arm_push.size(); ++i)
    on_the_way.arm_push[i] += fraction * (healthy.arm_push[i] - traits.arm_push[i]);
  return on_the_way;
}

PatientTraits practised(const PatientTraits& traits, double sessions) {
  const double gain =
      traits.practice_gain * (1.0 - std::exp(-std::max(0.0, sessions) / traits.practice_sessions));
  PatientTraits skilled = traits;
  skilled.prediction += gain * (1.0 - traits.prediction);
  for (const auto trait : {&T::force_cv, &T::movement_s, &T::memory_cv, &T::memory_loss})
    skilled.*trait *= 1.0 - gain;
  return skilled;
}

PatientTraits on_day(const PatientTraits& traits, std::uint64_t day_seed) {
  constexpr std::uint64_t kStream = 110;
  Random random(day_seed, kStream);
  PatientTraits today = traits;
  const double cv = traits.day_cv;
  for (const auto trait : {&T::maximum_force_N, &T::resting_force_N, &T::release_s})
    today.*trait *= std::exp(cv * random.gaussian() - 0.5 * cv * cv);
  return clamped(today);
}

std::uint64_t day_seed(std::uint64_t person_seed, std::uint64_t day) noexcept {
  // An odd factor: seeds of different days and people do not coincide below 2^63 / 1e9 days.
  constexpr std::uint64_t kDaysApart = 1'000'000'007U;
  return person_seed * kDaysApart + day;
}

}  // namespace isograsp::virtual_patient
