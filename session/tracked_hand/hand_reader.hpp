// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a tracker as the frames of a session, which run at a rate of their own: each shows the
// hand as it was one period of the tracker ago, between the two rows around that instant. A stream
// that falls silent does not stop the frames.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/time.hpp"
#include "device/hand/hand_device.hpp"

namespace isograsp::session {

/// The hand in one frame of the session.
struct ShownHand {
  /// Joints [m] in the world of the tracker; not given: NaN. t_s is that of the session. While it
  /// is not seen, as it was seen last.
  HandFrame frame;
  bool known = false;  ///< it has been seen; else `frame` has no joints
  bool held = true;    ///< it is not seen: what is shown stands still
  /// Since it was seen last, 0 where it is seen [s]; before that, since the start.
  double unseen_s = 0.0;
};

class HandReader {
 public:
  /// A gap between two rows that is longer is no movement to be filled in [s].
  static constexpr double kLongestStep_s = 0.2;

  /// `side` is the hand of the session. Frames begin at `start`.
  HandReader(HandDevice& device, Hand side, double period_s, Timestamp start) noexcept;

  /// The next frame; false: there will be none any more. Real-time safe.
  [[nodiscard]] bool next() noexcept;

  /// Time of the frame since the first one [s].
  [[nodiscard]] double t_s() const noexcept { return static_cast<double>(frame_) * period_s_; }
  [[nodiscard]] const ShownHand& hand() const noexcept { return shown_; }
  /// The instant that the frame shows.
  [[nodiscard]] Timestamp stamp() const noexcept { return shows_; }

 private:
  static constexpr std::size_t kMostWaiting = 64;  // rows of half a second at 120 Hz

  [[nodiscard]] const HandSample& waiting(std::size_t k) const noexcept {
    return queue_[(first_ + k) % kMostWaiting];
  }
  /// Takes what has come; false: no more will.
  [[nodiscard]] bool fill(Timestamp deadline) noexcept;
  void pass() noexcept;
  void show() noexcept;

  HandDevice& device_;
  Hand side_;
  double period_s_;
  Timestamp start_;
  std::array<HandSample, kMostWaiting> queue_;  ///< rows later than what was shown last
  std::size_t first_ = 0, count_ = 0;
  std::optional<HandSample> before_;  ///< the last row at or before what is shown
  Timestamp seen_{0};                 ///< of the last row in which the hand was seen
  std::int64_t frame_ = -1;
  Timestamp shows_{0};
  ShownHand shown_;
};

/// The hand between two rows, `share` from 0 (the first) to 1: joints go straight; one that either
/// does not give is not given. Side and confidence (the lower one) are of both. Real-time safe.
[[nodiscard]] HandFrame between(const HandFrame& first, const HandFrame& second,
                                double share) noexcept;

}  // namespace isograsp::session
