// SPDX-License-Identifier: GPL-3.0-or-later
// A hand as trackers give it: the positions of 26 joints, those of OpenXR. SI units, world W of the
// tracker (x right, y up, z to the viewer).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/spatial.hpp"
#include "hand/finger.hpp"

namespace isograsp {

enum class Digit : std::uint8_t { thumb, index, middle, ring, little };
inline constexpr std::size_t kDigitCount = 5;
inline constexpr std::array<std::string_view, kDigitCount> kDigitNames{"thumb", "index", "middle",
                                                                       "ring", "little"};
[[nodiscard]] constexpr std::size_t index_of(Digit digit) noexcept {
  return static_cast<std::size_t>(digit);
}

/// The joints of OpenXR, in its order.
inline constexpr std::size_t kHandJointCount = 26;
inline constexpr std::array<std::string_view, kHandJointCount> kHandJointNames{
    "palm",
    "wrist",
    "thumb_metacarpal",
    "thumb_proximal",
    "thumb_distal",
    "thumb_tip",
    "index_metacarpal",
    "index_proximal",
    "index_intermediate",
    "index_distal",
    "index_tip",
    "middle_metacarpal",
    "middle_proximal",
    "middle_intermediate",
    "middle_distal",
    "middle_tip",
    "ring_metacarpal",
    "ring_proximal",
    "ring_intermediate",
    "ring_distal",
    "ring_tip",
    "little_metacarpal",
    "little_proximal",
    "little_intermediate",
    "little_distal",
    "little_tip"};
inline constexpr std::size_t kPalmJoint = 0;
inline constexpr std::size_t kWristJoint = 1;
/// Where a digit's own links begin and end, `end` from 0 (its base) to 3 (its tip).
[[nodiscard]] constexpr std::size_t joint_of(Digit digit, std::size_t end) noexcept {
  const std::size_t d = index_of(digit);
  return d == 0 ? 2 + end : 7 + 5 * (d - 1) + end;
}
/// Where its metacarpal begins; the thumb's is its first link.
[[nodiscard]] constexpr std::size_t metacarpal_joint_of(Digit digit) noexcept {
  return digit == Digit::thumb ? joint_of(digit, 0) : joint_of(digit, 0) - 1;
}

/// One hand at one time.
struct HandFrame {
  double t_s = 0.0;
  Hand side = Hand::right;
  bool tracked = false;
  double confidence = 1.0;                   ///< 0 to 1; 1 where the tracker tells none
  std::array<Vec3, kHandJointCount> joints;  ///< [m]; not given: NaN in all three places
};

}  // namespace isograsp
