// SPDX-License-Identifier: GPL-3.0-or-later
// A force channel makes one number of three fingertip forces: it says which digits are taken, and
// in which direction. Contact frames: z into the object, so closing is +z and opening -z. SI units.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

#include "hand/finger.hpp"

namespace isograsp {

/// The digits that a force is taken from.
enum class Digits : std::uint8_t {
  grip,       ///< the smaller of the thumb and the two opposing fingers together
  grip_mean,  ///< the mean of these two
  pinch,      ///< the smaller of thumb and index
  sum,        ///< of all three
  thumb,
  index,
  middle
};

inline constexpr std::size_t kDigitsCount = 7;

/// Along an axis of the contact frame.
enum class Direction : std::uint8_t { plus_x, minus_x, plus_y, minus_y, plus_z, minus_z };
inline constexpr std::size_t kDirectionCount = 6;
[[nodiscard]] constexpr bool is_normal(Direction direction) noexcept {
  return direction >= Direction::plus_z;
}
/// Unit vector in the contact frame.
[[nodiscard]] Vec3 axis_of(Direction direction) noexcept;

struct ForceChannel {
  Digits digits = Digits::grip;
  Direction direction = Direction::plus_z;
  auto operator<=>(const ForceChannel&) const = default;
};

/// "grip", "pinch", "index"; opening: "opening", "index_opening"; sideways: "thumb_-x".
[[nodiscard]] std::string name_of(ForceChannel channel);
[[nodiscard]] std::optional<ForceChannel> force_channel_from_name(std::string_view name);
/// The finger of a channel that is taken from one alone.
[[nodiscard]] std::optional<Finger> single_digit(ForceChannel channel) noexcept;
[[nodiscard]] constexpr ForceChannel channel_of(Finger finger,
                                                Direction direction = Direction::plus_z) noexcept {
  return {static_cast<Digits>(index_of(finger) + static_cast<std::size_t>(Digits::thumb)),
          direction};
}

/// The force [N], signed: positive along the direction of the channel. Real-time safe.
[[nodiscard]] double force_of(const FingerWrenches& wrench_C, ForceChannel channel) noexcept;

/// SD of that force [N] from independent SDs of the digits along its axis: of the noisier side
/// where the smaller of two counts. Real-time safe.
[[nodiscard]] double noise_of(const std::array<Vec3, kFingerCount>& sd_N,
                              ForceChannel channel) noexcept;

}  // namespace isograsp
