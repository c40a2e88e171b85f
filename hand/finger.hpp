// SPDX-License-Identifier: GPL-3.0-or-later
// Fingers, hands and the frame of three finger wrenches that travels through the program.
// Wrenches are in the finger's contact frame C: z into the object, so pressing is +z. SI units.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/spatial.hpp"

namespace isograsp {

enum class Finger : std::uint8_t { thumb, index, middle };
inline constexpr std::size_t kFingerCount = 3;
inline constexpr std::array<Finger, kFingerCount> kFingers{Finger::thumb, Finger::index,
                                                           Finger::middle};
inline constexpr std::array<std::string_view, kFingerCount> kFingerNames{"thumb", "index",
                                                                         "middle"};

[[nodiscard]] constexpr std::size_t index_of(Finger finger) noexcept {
  return static_cast<std::size_t>(finger);
}
[[nodiscard]] constexpr std::string_view name_of(Finger finger) noexcept {
  return kFingerNames[index_of(finger)];
}
[[nodiscard]] std::optional<Finger> finger_from_name(std::string_view name) noexcept;

enum class Hand : std::uint8_t { right, left };
[[nodiscard]] constexpr std::string_view name_of(Hand hand) noexcept {
  return hand == Hand::right ? "right" : "left";
}
[[nodiscard]] std::optional<Hand> hand_from_name(std::string_view name) noexcept;

/// One wrench per finger, each in its own contact frame [N, N m].
using FingerWrenches = std::array<Wrench, kFingerCount>;

/// Six axes of a sensor as the device sent them: Fx Fy Fz Tx Ty Tz in counts.
using RawCounts = std::array<std::int32_t, 6>;

/// What is known about one finger's value in one frame; bits may be combined, 0 = valid.
enum class SampleFlag : std::uint8_t {
  valid = 0,
  held = 1,       ///< no sample in this slot: the last valid one stands in (at most 50 ms)
  missing = 2,    ///< no sample and nothing to hold: the value means nothing
  saturated = 4,  ///< at or above 98 % of the range of an axis
  overload = 8    ///< the sensor reports overload
};
[[nodiscard]] constexpr std::uint8_t bit(SampleFlag flag) noexcept {
  return static_cast<std::uint8_t>(flag);
}

/// Three fingers at one instant of the strict grid.
struct FingerFrame {
  std::int64_t slot = 0;  ///< number of the grid point; time = slot / rate
  double t_s = 0.0;       ///< grid time since the clock started [s]
  FingerWrenches wrench_C{};
  std::array<RawCounts, kFingerCount> raw_counts{};
  std::array<std::uint8_t, kFingerCount> flags{};  ///< SampleFlag bits

  [[nodiscard]] bool any(SampleFlag flag) const noexcept {
    return ((flags[0] | flags[1] | flags[2]) & bit(flag)) != 0;
  }
};

}  // namespace isograsp
