// SPDX-License-Identifier: GPL-3.0-or-later
// What the Leap service says (JSON, protocol v6), in software. No socket and no clock.
#pragma once

#include <string>
#include <string_view>

#include "device/hand/hand_play.hpp"

namespace isograsp {

/// What it greets with: its version, and that a camera is there.
[[nodiscard]] std::string leap_greeting();
[[nodiscard]] std::string leap_device_event();
/// A frame; hands that are not tracked are not in it. Lengths in millimetres, times in whole
/// microseconds.
[[nodiscard]] std::string leap_frame(const HandPicture& picture, double rate_Hz);
/// A client has asked to get frames although nobody may look at it.
[[nodiscard]] bool asks_for_frames(std::string_view message);

}  // namespace isograsp
