// SPDX-License-Identifier: GPL-3.0-or-later
// What makes a person who grasps virtual objects before a tracker (docs/virtual_patient.md, "The
// hand"). A software test instrument, not data: every number is an assumption in a plausible range.
// The defaults are those of a healthy person. SI units, angles in rad.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace isograsp::virtual_patient {

struct GraspTraits {
  // Seeing and deciding
  double visual_delay_s = 0.18;
  double reaction_s = 0.25;  ///< from perceiving something new to moving
  double sight_m = 0.0015;   ///< SD of a distance as it is seen, each axis
  double sight_rad = 0.02;   ///< SD of a turn as it is seen
  double aim_m = 0.004;      ///< an error below both is good enough for them
  double aim_rad = 0.06;

  // Moving
  double reach_s = 0.8;          ///< a way of 0.3 m; grows with its square root
  double place_m = 0.003;        ///< SD of where the hand is brought to, each axis
  double close_s = 0.4;          ///< the digits, from open to closed
  double open_s = 0.35;          ///< … and back
  double squeeze_m = 0.006;      ///< the digits close to so much less than the object is wide
  double harder_m = 0.002;       ///< … and by this more after it slipped, again and again
  double squeeze_sd_m = 0.0015;  ///< from grasp to grasp
  double opening_m = 0.12;       ///< from thumb to index, as far as they open
  double spare_m = 0.04;         ///< they open so much farther than the object is wide

  // What the tracker makes of it
  double tracker_delay_s = 0.03;
  double tracker_m = 0.0005;  ///< SD of each joint in each picture, each axis
  double wander_m = 0.003;    ///< rms length of slow errors: of the palm, and of each tip beside it
  double wander_Hz = 0.5;     ///< up to this frequency
  double lost_share = 0.02;   ///< of the time in which the hand is not seen …
  double lost_least_s = 0.05;  ///< … for so long
  double lost_most_s = 0.15;
  double size_error = 0.05;  ///< the hand is taken for larger or smaller, at most by this share

  bool operator==(const GraspTraits&) const = default;
};

/// A trait and the values that make sense.
struct GraspTraitField {
  std::string_view key;
  double GraspTraits::*value;
  double least;
  double most;
};
[[nodiscard]] std::span<const GraspTraitField> grasp_trait_fields() noexcept;

/// The names of grasp_traits().
[[nodiscard]] std::span<const std::string_view> grasper_names() noexcept;
/// "healthy" | "paretic"; nullopt for any other name.
[[nodiscard]] std::optional<GraspTraits> grasp_traits(std::string_view name) noexcept;

}  // namespace isograsp::virtual_patient
