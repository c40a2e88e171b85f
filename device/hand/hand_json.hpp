// SPDX-License-Identifier: GPL-3.0-or-later
// One hand as a JSON object of its own, as scripts send it:
//   {"t_s": 12.25, "hand": "right", "joints": {"wrist": [x, y, z], …}}
// 26 joints, or the 21 without the palm and the metacarpals of the four fingers; none of them where
// the hand is not seen. Metres, x right, y up, z to the viewer. Pure: no socket, no clock.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hand/tracked_hand.hpp"

namespace isograsp {

/// Longest message that is read [bytes]: 26 joints take 2.5 kB.
inline constexpr std::size_t kLongestHandJson = std::size_t{1} << 14;

/// t_s is that of the script. Nothing: no JSON object, a key or a joint that is missing, unknown or
/// no number, places farther than 100 m. `confidence` (0 to 1) may be left out. Joints that are
/// null are not given.
[[nodiscard]] std::optional<HandFrame> parse_hand_json(std::string_view message);

/// The reverse; a hand that is not tracked has no joints.
[[nodiscard]] std::string hand_json(const HandFrame& frame);

}  // namespace isograsp
