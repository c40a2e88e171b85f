// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a tracker become what drags the virtual hand: links where the joints are, linearly
// between two frames (docs/virtual_hand.md, "Coupling"). SI units.
#pragma once

#include <optional>

#include "hand_world/hand_body.hpp"

namespace isograsp::hand_world {

/// Palm and links of a frame at rest: middles are those of the tracked joints, a link points along
/// its joints and turns about itself as in the pose that fits best. Nothing: joints are missing.
[[nodiscard]] std::optional<HandTarget> target_of_frame(const virtual_hand::HandModel& model,
                                                        const HandFrame& frame) noexcept;

/// Velocities above these are a tracker's jumps.
inline constexpr double kMostTracked_m_s = 2.0;
inline constexpr double kMostTracked_rad_s = 20.0;

/// The way from one target to another that takes `span_s`: poses linearly, `share` of it gone,
/// turns about one axis; velocities are its slope, no larger than the limits above. Real-time safe.
[[nodiscard]] HandTarget between_targets(const HandTarget& from, const HandTarget& to, double share,
                                         double span_s) noexcept;
/// The largest distance between middles of palm and links [m]. Real-time safe.
[[nodiscard]] double furthest(const HandTarget& from, const HandTarget& to) noexcept;

}  // namespace isograsp::hand_world
