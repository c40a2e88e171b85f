// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that found the transmit queue of the kernel full. They leave in their order when there is
// room again, unless they have waited too long: a question or a synchronisation that comes a period
// late gives samples a wrong time, so it is dropped and counted instead.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/time.hpp"
#include "device/bus/frame.hpp"

namespace isograsp {

/// No allocation.
class WaitingFrames {
 public:
  /// One period at 100 Hz. A bus that works empties a full queue sooner: twelve frames take 6.5 ms
  /// at 250 kbit/s.
  static constexpr Timestamp kLongestWait = std::chrono::milliseconds(10);

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  /// False if there is no room: the frame is counted as given up.
  bool push(const BusFrame& frame, Timestamp now) noexcept {
    if (count_ == kRoom) {
      ++given_up_;
      return false;
    }
    frames_[(first_ + count_++) % kRoom] = {frame, now + kLongestWait};
    return true;
  }
  /// Gives up what has waited too long, then hands the others to `write` until it says false.
  template <class Write>
  void leave(Timestamp now, Write&& write) noexcept {
    while (count_ > 0 && frames_[first_].give_up_at <= now) {
      ++given_up_;
      drop_first();
    }
    while (count_ > 0 && write(frames_[first_].frame)) drop_first();
  }
  void give_up_all() noexcept {
    given_up_ += count_;
    count_ = 0;
  }
  /// Number of frames given up so far.
  [[nodiscard]] std::uint64_t given_up() const noexcept { return given_up_; }

 private:
  static constexpr std::size_t kRoom = 32;
  struct Waiting {
    BusFrame frame;
    Timestamp give_up_at{0};
  };
  void drop_first() noexcept {
    first_ = (first_ + 1) % kRoom;
    --count_;
  }

  std::array<Waiting, kRoom> frames_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::uint64_t given_up_ = 0;
};

}  // namespace isograsp
