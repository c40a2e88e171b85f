// SPDX-License-Identifier: GPL-3.0-or-later
// What a lost hand means for a session: for a moment it stands still and everything that is tied to
// it, for longer the trial waits and goes on by itself; a tracker that is broken is the
// therapist's. It is never a drop. Pure: no device, no clock. Real-time safe.
#pragma once

#include <cstdint>

#include "device/hand/hand_device.hpp"
#include "hand_world/assisted_grasp.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/tracked_hand/hand_reader.hpp"

namespace isograsp::session {

/// A hand that is lost for this long stands still [s]; beyond it the trial waits.
inline constexpr double kLongestLoss_s = 0.2;

/// How one frame was received, by what is shown of the hand and what is wrong with the tracker.
/// `gap`: the frame is held, and left out of measures.
[[nodiscard]] Reception hand_reception(const ShownHand& hand, HandFault fault) noexcept;

/// Flags of its row: held while the hand stands still for a moment, then missing.
[[nodiscard]] std::uint8_t hand_flags(const ShownHand& hand) noexcept;
/// A digit touches the object, or is tied to it.
[[nodiscard]] bool touches(const hand_world::GraspState& grasp) noexcept;

}  // namespace isograsp::session
