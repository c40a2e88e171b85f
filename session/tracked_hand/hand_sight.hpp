// SPDX-License-Identifier: GPL-3.0-or-later
// What a lost hand means for a session: for a moment it stands still and everything that is tied to
// it, for longer the trial waits and goes on by itself; a tracker that is broken is the
// therapist's. It is never a drop. Pure: no device, no clock. Real-time safe.
#pragma once

#include <cstdint>

#include "device/hand/hand_device.hpp"
#include "session/acquisition/apparatus.hpp"
#include "session/tracked_hand/hand_reader.hpp"

namespace isograsp::session {

/// A hand that is lost for this long stands still [s]; beyond it the trial waits.
inline constexpr double kLongestLoss_s = 0.2;

/// How one frame was received, by what is shown of the hand and what is wrong with the tracker.
/// `gap`: the frame is held, and left out of measures.
[[nodiscard]] Reception hand_reception(const ShownHand& hand, HandFault fault) noexcept;

/// Frames of one placement, and how many of them were without the hand.
class LostShare {
 public:
  /// Of its frames: with more of them lost a placement is not scored, and repeated.
  static constexpr double kMost = 0.1;

  void begin() noexcept { frames_ = lost_ = 0; }
  void add(bool lost) noexcept {
    ++frames_;
    lost_ += lost ? 1 : 0;
  }
  /// 0 … 1; of no frame 1.
  [[nodiscard]] double share() const noexcept {
    return frames_ == 0 ? 1.0 : static_cast<double>(lost_) / static_cast<double>(frames_);
  }
  [[nodiscard]] bool can_be_scored() const noexcept { return share() <= kMost; }

 private:
  std::int64_t frames_ = 0;
  std::int64_t lost_ = 0;
};

}  // namespace isograsp::session
