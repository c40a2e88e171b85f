// SPDX-License-Identifier: GPL-3.0-or-later
#include "virtual_patient/arm/arm_traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace isograsp::virtual_patient {

namespace {

using Arm = ArmTraits;

constexpr double kHalfTurn_rad = std::numbers::pi;

// The ranges find mistakes (degrees for radians, millimetres for metres), not unusual people.
constexpr std::array kArmFields{
    ArmTraitField{"visual_delay_s", &Arm::visual_delay_s, 0.02, 0.9},
    ArmTraitField{"reaction_s", &Arm::reaction_s, 0.05, 5.0},
    ArmTraitField{"reaction_cv", &Arm::reaction_cv, 0.0, 1.0},
    ArmTraitField{"sight_m", &Arm::sight_m, 0.0, 0.05},
    ArmTraitField{"depth_m", &Arm::depth_m, 0.0, 0.1},
    ArmTraitField{"sight_rad", &Arm::sight_rad, 0.0, 0.5},
    ArmTraitField{"aim_m", &Arm::aim_m, 0.0, 0.1},
    ArmTraitField{"aim_rad", &Arm::aim_rad, 0.0, 1.0},
    ArmTraitField{"movement_s", &Arm::movement_s, 0.2, 20.0},
    ArmTraitField{"movement_cv", &Arm::movement_cv, 0.0, 0.3},
    ArmTraitField{"first_gain", &Arm::first_gain, 0.2, 1.0},
    ArmTraitField{"amplitude_cv", &Arm::amplitude_cv, 0.0, 0.5},
    ArmTraitField{"wander_rad", &Arm::wander_rad, 0.0, 0.2},
    ArmTraitField{"wander_s", &Arm::wander_s, 0.05, 10.0},
    ArmTraitField{"tremor_rad", &Arm::tremor_rad, 0.0, 0.2},
    ArmTraitField{"tremor_Hz", &Arm::tremor_Hz, 1.0, 15.0},
    ArmTraitField{"forearm_share", &Arm::forearm_share, 0.01, 1.0},
    ArmTraitField{"wrist_share", &Arm::wrist_share, 0.01, 1.0},
    ArmTraitField{"finger_share", &Arm::finger_share, 0.01, 1.0},
    ArmTraitField{"shoulder_share", &Arm::shoulder_share, 0.0, 1.0},
    ArmTraitField{"trunk_share", &Arm::trunk_share, 0.0, 1.0},
    ArmTraitField{"forearm_lag", &Arm::forearm_lag, 0.0, 1.0},
    ArmTraitField{"wrist_lag", &Arm::wrist_lag, 0.0, 1.0},
    ArmTraitField{"pronation_rad", &Arm::pronation_rad, 0.0, kHalfTurn_rad},
    ArmTraitField{"supination_rad", &Arm::supination_rad, 0.0, kHalfTurn_rad},
    ArmTraitField{"flexion_rad", &Arm::flexion_rad, 0.0, 2.0},
    ArmTraitField{"extension_rad", &Arm::extension_rad, 0.0, 2.0},
    ArmTraitField{"radial_rad", &Arm::radial_rad, 0.0, 1.0},
    ArmTraitField{"ulnar_rad", &Arm::ulnar_rad, 0.0, 1.0},
    ArmTraitField{"finger_turn_rad", &Arm::finger_turn_rad, 0.0, 2.0},
    ArmTraitField{"finger_shift_m", &Arm::finger_shift_m, 0.0, 0.1},
    ArmTraitField{"lift_rad", &Arm::lift_rad, 0.0, 1.5},
    ArmTraitField{"lean_m", &Arm::lean_m, 0.0, 0.5},
    ArmTraitField{"forearm_m", &Arm::forearm_m, 0.1, 0.4},
    ArmTraitField{"upper_arm_m", &Arm::upper_arm_m, 0.1, 0.5},
    ArmTraitField{"palm_m", &Arm::palm_m, 0.03, 0.15},
    ArmTraitField{"reach_m", &Arm::reach_m, 0.05, 0.25},
    ArmTraitField{"size_cv", &Arm::size_cv, 0.0, 0.15},
    ArmTraitField{"placement_m", &Arm::placement_m, 0.0, 0.01},
    ArmTraitField{"start_pronation_rad", &Arm::start_pronation_rad, -1.0, 1.0},
    ArmTraitField{"start_extension_rad", &Arm::start_extension_rad, -1.0, 1.0},
    ArmTraitField{"start_sd_rad", &Arm::start_sd_rad, 0.0, 0.2},
    ArmTraitField{"share_cv", &Arm::share_cv, 0.0, 0.5},
    ArmTraitField{"tempo_cv", &Arm::tempo_cv, 0.0, 0.5},
    ArmTraitField{"skin_m", &Arm::skin_m, 0.0, 0.01},
    ArmTraitField{"skin_s", &Arm::skin_s, 0.01, 10.0},
    ArmTraitField{"camera_m", &Arm::camera_m, 0.0, 0.01},
    ArmTraitField{"loss_per_s", &Arm::loss_per_s, 0.0, 10.0},
    ArmTraitField{"loss_s", &Arm::loss_s, 0.0, 10.0},
    ArmTraitField{"block_per_s", &Arm::block_per_s, 0.0, 1.0},
    ArmTraitField{"block_s", &Arm::block_s, 0.0, 60.0},
    ArmTraitField{"view_rad", &Arm::view_rad, 0.5, kHalfTurn_rad},
    ArmTraitField{"day_cv", &Arm::day_cv, 0.0, 0.5},
};

constexpr std::array<std::string_view, 2> kNames{"healthy", "paretic"};

/// exp(cv g - cv^2 / 2): mean 1.
double factor(Random& random, double cv) noexcept {
  return std::exp(cv * random.gaussian() - 0.5 * cv * cv);
}

}  // namespace

std::span<const ArmTraitField> arm_trait_fields() noexcept {
  return kArmFields;
}

ArmTraits clamped(ArmTraits traits) noexcept {
  for (const ArmTraitField& field : kArmFields)
    traits.*field.value = std::clamp(traits.*field.value, field.least, field.most);
  return traits;
}

std::span<const std::string_view> arm_names() noexcept {
  return kNames;
}

std::optional<ArmTraits> arm_traits(std::string_view name) noexcept {
  ArmTraits traits;
  if (name == "healthy") return traits;
  if (name != "paretic") return std::nullopt;
  traits.visual_delay_s = 0.25;
  traits.reaction_s = 0.50;
  traits.reaction_cv = 0.4;
  traits.aim_m = 0.007;
  traits.aim_rad = 0.10;
  traits.movement_s = 2.2;
  traits.movement_cv = 0.15;
  traits.first_gain = 0.7;
  traits.amplitude_cv = 0.12;
  traits.wander_rad = 0.012;
  traits.tremor_rad = 0.004;
  traits.tremor_Hz = 6.0;
  traits.forearm_share = 0.35;
  traits.finger_share = 0.12;
  traits.shoulder_share = 0.15;
  traits.trunk_share = 0.25;
  traits.forearm_lag = 0.05;
  traits.wrist_lag = 0.02;
  traits.pronation_rad = 0.65;
  traits.supination_rad = 0.1;
  traits.flexion_rad = 0.8;
  traits.extension_rad = 0.4;
  traits.radial_rad = 0.25;
  traits.ulnar_rad = 0.35;
  traits.finger_turn_rad = 0.25;
  traits.finger_shift_m = 0.008;
  traits.lift_rad = 0.2;
  traits.lean_m = 0.04;
  traits.share_cv = 0.2;
  traits.tempo_cv = 0.2;
  traits.loss_per_s = 0.03;
  traits.day_cv = 0.1;
  return traits;
}

ArmTraits recovered(const ArmTraits& traits, double fraction) noexcept {
  const ArmTraits healthy;
  ArmTraits on_the_way = traits;
  for (const ArmTraitField& field : kArmFields)
    on_the_way.*field.value += fraction * (healthy.*field.value - traits.*field.value);
  return on_the_way;
}

ArmTraits arm_on_day(const ArmTraits& traits, std::uint64_t day_seed) noexcept {
  constexpr std::uint64_t kStream = 210;
  Random random(day_seed, kStream);
  ArmTraits today = traits;
  const double range = factor(random, traits.day_cv);
  for (const auto trait :
       {&Arm::pronation_rad, &Arm::supination_rad, &Arm::flexion_rad, &Arm::extension_rad,
        &Arm::radial_rad, &Arm::ulnar_rad, &Arm::finger_turn_rad})
    today.*trait *= range;
  const double tempo = factor(random, traits.day_cv);
  for (const auto trait : {&Arm::reaction_s, &Arm::movement_s}) today.*trait *= tempo;
  return clamped(today);
}

ArmTraits drawn(const ArmTraits& traits, std::uint64_t seed) noexcept {
  constexpr std::uint64_t kStream = 200;
  Random random(seed, kStream);
  ArmTraits person = traits;
  const double size = factor(random, traits.size_cv);
  for (const auto trait : {&Arm::forearm_m, &Arm::upper_arm_m, &Arm::palm_m, &Arm::reach_m})
    person.*trait *= size;
  for (const auto trait : {&Arm::start_pronation_rad, &Arm::start_extension_rad})
    person.*trait += traits.start_sd_rad * random.gaussian();
  for (const auto trait :
       {&Arm::forearm_share, &Arm::wrist_share, &Arm::finger_share, &Arm::shoulder_share,
        &Arm::trunk_share, &Arm::forearm_lag, &Arm::wrist_lag})
    person.*trait *= factor(random, traits.share_cv);
  const double tempo = factor(random, traits.tempo_cv);
  for (const auto trait : {&Arm::reaction_s, &Arm::movement_s}) person.*trait *= tempo;
  return clamped(person);
}

}  // namespace isograsp::virtual_patient
