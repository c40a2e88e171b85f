// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of a tracker become what drags the virtual hand: links where the joints are, linearly
// between two frames and one frame late (docs/virtual_hand.md, "Coupling"). SI units.
#pragma once

#include <array>
#include <optional>

#include "hand_world/hand_body.hpp"

namespace isograsp::hand_world {

/// Palm and links of a frame at rest: middles are those of the tracked joints, a link points along
/// its joints and turns about itself as in the pose that fits best. Nothing: joints are missing.
[[nodiscard]] std::optional<HandTarget> target_of_frame(const virtual_hand::HandModel& model,
                                                        const HandFrame& frame) noexcept;

/// Real-time safe.
class TrackedTarget {
 public:
  static constexpr double kMost_m_s = 2.0;  ///< velocities above are a tracker's jumps
  static constexpr double kMost_rad_s = 20.0;

  /// `period_s`: nominal, between two frames; the target is late by so much.
  explicit TrackedTarget(double period_s) noexcept : period_s_(period_s) {}

  /// A frame. False: its time is not later than that of the last one, and it does not count.
  bool add(double t_s, const HandTarget& target) noexcept;
  /// Forgets all frames: after a gap the hand begins anew.
  void clear() noexcept { count_ = 0; }
  /// The target at a time; stands still before the first frame and behind the last one. Nothing:
  /// there is no frame.
  [[nodiscard]] std::optional<HandTarget> at(double t_s) const noexcept;

 private:
  struct Frame {
    double t_s = 0.0;
    HandTarget target;
  };
  static constexpr std::size_t kKept = 4;  ///< two frames and their jitter
  double period_s_;
  std::array<Frame, kKept> frames_;  ///< the newest is the last of count_
  std::size_t count_ = 0;
};

}  // namespace isograsp::hand_world
