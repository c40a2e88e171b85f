// SPDX-License-Identifier: GPL-3.0-or-later
// A hand of 26 degrees of freedom: six of the palm, four of each digit (Delrieu et al., virtual
// hand; docs/virtual_hand.md). SI units, radians. Frame P of the palm: origin at the wrist, -z to
// the fingers, +y out of the back of the hand; of a right hand +x to the little finger. What a
// model holds is a right hand; a left one is its reflection S = diag(-1, 1, 1) in P.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/spatial.hpp"
#include "hand/tracked_hand.hpp"

namespace isograsp::virtual_hand {

inline constexpr std::size_t kLinkCount = 3;   ///< of a digit; of the thumb its metacarpal first
inline constexpr std::size_t kAngleCount = 4;  ///< abduction, three flexions
inline constexpr std::array<std::string_view, kAngleCount> kDigitAngleNames{"abduction", "flexion1",
                                                                            "flexion2", "flexion3"};
/// Abduction is positive to the thumb's side, flexion to the palm [rad].
using DigitAngles = std::array<double, kAngleCount>;
struct AngleRange {
  double least = 0.0;  ///< [rad]
  double most = 0.0;
};

/// One digit of a right hand, in P.
struct DigitModel {
  Vec3 metacarpal_m = Vec3::Zero();  ///< where its metacarpal begins
  Vec3 base_m = Vec3::Zero();        ///< where its first link begins
  Quat base_q = Quat::Identity();    ///< axes at its base: -z along the straight digit
  std::array<double, kLinkCount> lengths_m{};
  std::array<double, kLinkCount> radii_m{};  ///< of the capsules around the links
  std::array<AngleRange, kAngleCount> limits{};
};

struct HandModel {
  std::string name;
  Hand side = Hand::right;
  double length_m = 0.0;   ///< wrist to the tip of the middle finger
  double breadth_m = 0.0;  ///< over the knuckles
  std::array<DigitModel, kDigitCount> digits;

  [[nodiscard]] const DigitModel& digit(Digit which) const noexcept {
    return digits[index_of(which)];
  }
};

/// Reads a hand file ("isograsp-hand-1"); `path` is named in errors.
[[nodiscard]] Result<HandModel> parse_hand(std::string_view text, const std::string& path);
/// The file of a hand; parse_hand() reads it back to the bit.
[[nodiscard]] std::string hand_text(const HandModel& hand);

}  // namespace isograsp::virtual_hand
