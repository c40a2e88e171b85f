// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from the positions of a tracked hand's joints alone: its palm, its size, its angles
// (docs/virtual_hand.md). SI units, world W of the tracker.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/result.hpp"
#include "virtual_hand/hand_pose.hpp"

namespace isograsp::virtual_hand {

/// The palm: origin at the wrist, -z to the middle knuckle, +y out of the back. Nothing: a joint
/// that it needs is not given, or they lie on a line. Attitudes of trackers differ and are not
/// used.
[[nodiscard]] std::optional<Pose> palm_of(const HandFrame& frame) noexcept;

/// The hand of a person: lengths and bases are medians over the frames that are tracked with a
/// confidence of a half at least, component by component; radii, breadth and metacarpals that no
/// frame gives are those of `model`, scaled with the length of the hand; axes and limits stay.
struct CalibratedHand {
  HandModel hand;
  std::size_t frames = 0;  ///< that count
};
/// Errors: no frame counts, or a joint of a digit is never given.
[[nodiscard]] Result<CalibratedHand> calibrated_hand(std::span<const HandFrame> frames, Hand side,
                                                     const HandModel& model);

/// The pose of a hand that comes nearest to a frame link by link, abduction within its limits.
struct FittedPose {
  HandPose pose;
  double residual_m = 0.0;  ///< rms over the ends of the fifteen links
};
/// For the start of a hand and for display; it is not what drives the virtual hand. Nothing: joints
/// are missing.
[[nodiscard]] std::optional<FittedPose> fitted_pose(const HandModel& hand,
                                                    const HandFrame& frame) noexcept;

}  // namespace isograsp::virtual_hand
