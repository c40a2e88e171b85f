// SPDX-License-Identifier: GPL-3.0-or-later
// What a therapist reads of an arm while it works: how far the object is from its target, and how
// far each link has turned since that appeared. To look at: what is scored comes from the stored
// rows. Pure but for what was seen last. SI units, radians.
#pragma once

#include <array>
#include <optional>

#include "gui/picture/arm_space.hpp"
#include "session/arm/arm_snapshot.hpp"

namespace isograsp::gui {

/// From the object to the reference that is shown.
struct ReferenceError {
  double distance_m = 0.0;
  /// The part of it along the line of sight of the screen: without two pictures for two eyes that
  /// is harder to see.
  double depth_m = 0.0;
  double angle_rad = 0.0;
};
/// Nothing: no reference is shown, or the object is not seen.
[[nodiscard]] std::optional<ReferenceError> error_of(const session::ArmSnapshot& now,
                                                     const ArmSpace& space);

/// How far each link has turned since the target appeared, and its share of what all have turned.
class LinkTurns {
 public:
  struct Turn {
    std::optional<double> angle_rad;      ///< nothing: not seen, or not seen since the target
    std::optional<double> share_percent;  ///< nothing also: all together turned too little
  };
  /// Below it a share is that of the noise [rad].
  static constexpr double kLeastTurn_rad = 0.08726646259971647;  // 5 degrees

  void add(const session::ArmSnapshot& now);
  [[nodiscard]] std::array<Turn, kArmLinkCount> turns() const;

 private:
  int trial_ = 0;
  int target_ = -1;
  std::array<std::optional<Quat>, kArmLinkCount> first_;  ///< since the target
  std::array<std::optional<Quat>, kArmLinkCount> now_;
};

}  // namespace isograsp::gui
