// SPDX-License-Identifier: GPL-3.0-or-later
// The links of an arm that are seen by markers, called after what turns.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isograsp {

enum class ArmLink : std::uint8_t {
  forearm,  ///< elbow to forearm
  wrist,    ///< forearm to the back of the hand
  fingers   ///< back of the hand to the object
};
inline constexpr std::size_t kArmLinkCount = 3;
inline constexpr std::array<std::string_view, kArmLinkCount> kArmLinkNames{"forearm", "wrist",
                                                                           "fingers"};
[[nodiscard]] constexpr std::size_t index_of(ArmLink link) noexcept {
  return static_cast<std::size_t>(link);
}

/// One angle of a link, in the sequence of the rig.
struct LinkAngle {
  ArmLink link = ArmLink::forearm;
  int angle = 1;  ///< 1, 2 or 3
  bool operator==(const LinkAngle&) const = default;
};

/// How far somebody else turns one angle of an arm, from the zero of the rig.
struct PassiveLimit {
  LinkAngle angle;
  double least_rad = 0.0;
  double most_rad = 0.0;
  bool operator==(const PassiveLimit&) const = default;
};

}  // namespace isograsp
