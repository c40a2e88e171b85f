// SPDX-License-Identifier: GPL-3.0-or-later
// The closing-opening profile of a hand: forces of every digit in six directions, what it presses
// at rest, and how far beside the direction it pushes. In the axes of the hand
// (hand/anatomical_axes.hpp), so that a left hand and its mirror image give the same picture.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "hand/finger.hpp"
#include "hand/force_channel.hpp"

namespace isograsp::reports {

struct PatientRecords;

/// Two ways along each axis of the hand.
enum class CompassPoint : std::uint8_t { closing, opening, radial, ulnar, distal, proximal };
inline constexpr std::size_t kCompassPoints = 6;
[[nodiscard]] Words words_of(CompassPoint point) noexcept;
/// Of a force along an axis of the contact frame.
[[nodiscard]] CompassPoint compass_point(Direction direction, Finger finger, Hand hand) noexcept;

struct CompassDigit {
  std::array<std::optional<double>, kCompassPoints> force_N;    ///< largest, above rest
  std::array<std::optional<double>, kCompassPoints> error_rad;  ///< direction error
  std::optional<double> resting_N;          ///< pressed at rest; negative: pulled
  std::optional<double> coflexion_percent;  ///< press of any digit while this one opens
};
struct Compass {
  Hand hand = Hand::right;
  std::size_t session = 0;  ///< index into the sessions of the report
  std::array<CompassDigit, kFingerCount> digits;
};
/// Of the newest profile of each hand that was assessed; the right hand first.
[[nodiscard]] std::vector<Compass> compasses_of(const PatientRecords& records);
/// A round number above all forces [N].
[[nodiscard]] double compass_range(const std::vector<Compass>& compasses);

}  // namespace isograsp::reports
