// SPDX-License-Identifier: GPL-3.0-or-later
// What a person is asked to do just now.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isograsp {

/// The instruction on the patient's screen. Where it is about a force, the channel of that force
/// stands beside it.
enum class Cue : std::uint8_t {
  hand_out,   ///< "Please take your hand out of the device"
  relax,      ///< hand in, no force
  squeeze,    ///< as hard as you can, in the direction of the channel
  press,      ///< comfortably, and hold it
  follow,     ///< follow the force target, or hold it where the own force is not shown
  reproduce,  ///< the force held before, from memory
  let_go,     ///< now, as fast as you can
  move,       ///< bring the object to the target
  open,       ///< the hand, as far as it goes
  close       ///< the hand, as far as it goes
};
inline constexpr std::size_t kCueCount = 10;
[[nodiscard]] constexpr std::string_view name_of(Cue cue) noexcept {
  constexpr std::array<std::string_view, kCueCount> kNames{
      "hand out",  "relax",  "squeeze", "press", "follow",
      "reproduce", "let go", "move",    "open",  "close"};
  return kNames[static_cast<std::size_t>(cue)];
}

}  // namespace isograsp
