// SPDX-License-Identifier: GPL-3.0-or-later
// Postures changed by hand: one link of the chain is turned or moved, and all that lies beyond it
// goes along. What comes out is a posture again: unit quaternions, the same number of links.
#pragma once

#include <cstdint>
#include <vector>

#include "kinematics/postures.hpp"

namespace isograsp {

/// About whose axes, and from whose origin, a link is changed.
enum class EditAxes : std::uint8_t {
  own,    ///< of the segment behind the link: X_L T
  before  ///< of the segment in front of it: T X_L
};
enum class EditAxis : std::uint8_t { x, y, z };
inline constexpr std::size_t kEditAxisCount = 3;

/// A turn [rad], right-handed, or a shift [m] of one of those axes.
[[nodiscard]] Pose turn_about(EditAxis axis, double angle_rad);
[[nodiscard]] Pose shift_along(EditAxis axis, double way_m);

/// The posture with link `l` changed by T. @pre l < posture.X_L.size()
[[nodiscard]] Posture with_link_changed(Posture posture, std::size_t l, const Pose& T,
                                        EditAxes axes);

/// How far a link is from where it is in another posture.
struct LinkChange {
  double angle_rad = 0.0;
  double distance_m = 0.0;
};
/// Of each link of `posture`, from `initial`. @pre they have the same links
[[nodiscard]] std::vector<LinkChange> changes_from(const Posture& initial, const Posture& posture);

}  // namespace isograsp
