// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a virtual arm (docs/virtual_patient.md, "The arm"). A software test instrument, not
// data: every number is an assumption in a plausible range. The defaults are those of a healthy
// person of average size. SI units, angles in rad, shares are fractions.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace isograsp::virtual_patient {

struct ArmTraits {
  // Seeing and deciding
  double visual_delay_s = 0.18;
  double reaction_s = 0.30;  ///< from perceiving a target or an instruction to moving
  double reaction_cv = 0.2;  ///< each reaction takes (1 + cv |g|) times as long, g standard normal
  double sight_m = 0.0015;   ///< SD of a distance as it is seen, across the line of sight
  double depth_m = 0.004;    ///< the same along it: no stereo
  double sight_rad = 0.02;   ///< SD of a turn as it is seen
  double aim_m = 0.005;      ///< an error below both is good enough for them
  double aim_rad = 0.07;

  // Moving
  double movement_s = 0.9;     ///< duration of a turn of 1 rad; grows with its square root
  double movement_cv = 0.08;   ///< SD of a duration / its mean
  double first_gain = 0.97;    ///< share of the way that a first movement aims at
  double amplitude_cv = 0.04;  ///< SD of the way that each joint turns / intended
  double wander_rad = 0.004;   ///< slow unsteadiness of pronation, SD; of other joints a share
  double wander_s = 0.8;       ///< its time constant
  double tremor_rad = 0.001;   ///< amplitude
  double tremor_Hz = 9.0;

  // Sharing: compliances. Those who can turn about an axis share a turn in proportion to them.
  double forearm_share = 0.65;
  double wrist_share = 0.65;
  double finger_share = 0.35;
  double shoulder_share = 0.01;  ///< lifting it turns the forearm, too
  double trunk_share = 0.02;     ///< leaning moves the elbow
  double forearm_lag = 0.15;  ///< the forearm starts later than the fingers, share of the duration
  double wrist_lag = 0.08;    ///< the same of the wrist

  // Ranges, from the thumb up and the wrist straight
  double pronation_rad = 1.3;
  double supination_rad = 1.4;
  double flexion_rad = 1.2;
  double extension_rad = 1.1;
  double radial_rad = 0.35;
  double ulnar_rad = 0.55;
  double finger_turn_rad = 0.8;  ///< the object turned in the fingers, each axis, both ways
  double finger_shift_m = 0.02;  ///< … and shifted
  double lift_rad = 0.6;         ///< of the shoulder
  double lean_m = 0.12;          ///< of the trunk, each axis, both ways

  // Body
  double forearm_m = 0.25;  ///< elbow to wrist
  double upper_arm_m = 0.29;
  double palm_m = 0.075;       ///< wrist to the markers on the back of the hand
  double reach_m = 0.115;      ///< wrist to the object, along the hand
  double size_cv = 0.05;       ///< SD between people / mean, of all lengths together
  double placement_m = 0.004;  ///< SD of the place of a marker on the skin, each axis
  double start_pronation_rad = 0.35;
  double start_extension_rad = 0.14;
  double start_sd_rad = 0.05;  ///< between people, of every angle of the start posture
  double share_cv = 0.1;       ///< between people, of each share
  double tempo_cv = 0.1;       ///< between people, of reaction and movement time

  // What cameras make of it
  double skin_m = 0.0003;     ///< SD of a marker on moving skin, each axis
  double skin_s = 0.4;        ///< its time constant
  double camera_m = 0.00015;  ///< SD of each picture, each axis
  /// Losses of a marker that faces the cameras; at a grazing angle ten times that.
  double loss_per_s = 0.01;
  double loss_s = 0.06;  ///< mean duration of a loss
  /// Somebody steps before the cameras: all but the brace is lost, for block_s.
  double block_per_s = 0.0;
  double block_s = 1.0;
  /// A marker is seen from within this angle of its own direction; pi: from everywhere.
  double view_rad = 1.5;

  double day_cv = 0.0;  ///< between days, SD / mean of ranges and durations

  bool operator==(const ArmTraits&) const = default;
};

/// A trait and the values that make sense.
struct ArmTraitField {
  std::string_view key;
  double ArmTraits::*value;
  double least;
  double most;
};
[[nodiscard]] std::span<const ArmTraitField> arm_trait_fields() noexcept;
/// Every trait within its range.
[[nodiscard]] ArmTraits clamped(ArmTraits traits) noexcept;

/// The names of arm_traits().
[[nodiscard]] std::span<const std::string_view> arm_names() noexcept;
/// "healthy" | "paretic"; nullopt for any other name.
[[nodiscard]] std::optional<ArmTraits> arm_traits(std::string_view name) noexcept;

/// On the way from `traits` (fraction 0) to healthy (fraction 1), every trait linearly.
[[nodiscard]] ArmTraits recovered(const ArmTraits& traits, double fraction) noexcept;
/// The person as they are on one day: all active ranges together, and durations, each times
/// exp(cv g - cv^2 / 2). The seed is day_seed() of the person's (virtual_patient/traits.hpp).
[[nodiscard]] ArmTraits arm_on_day(const ArmTraits& traits, std::uint64_t day_seed) noexcept;
/// One person of these traits: size, start posture, shares and tempo drawn. The same seed draws the
/// same person.
[[nodiscard]] ArmTraits drawn(const ArmTraits& traits, std::uint64_t seed) noexcept;

}  // namespace isograsp::virtual_patient
