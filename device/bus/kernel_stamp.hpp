// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernel says beside a received message: when it arrived and how many were dropped before
// it. The stamps are on CLOCK_REALTIME; ClockMap moves them to CLOCK_MONOTONIC, the clock of
// Timestamp. Real-time safe.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <optional>

#include <sys/socket.h>
#include <time.h>

#include "core/time.hpp"

namespace isograsp {

[[nodiscard]] inline Timestamp read_clock(clockid_t id) noexcept {
  timespec t{};
  clock_gettime(id, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

/// CLOCK_REALTIME minus CLOCK_MONOTONIC, refreshed once per second and at once after a step of the
/// wall clock.
class ClockMap {
 public:
  /// Never later than now.
  [[nodiscard]] Timestamp to_steady(Timestamp wall) noexcept {
    const Timestamp now = read_clock(CLOCK_MONOTONIC);
    const Timestamp present = read_clock(CLOCK_REALTIME) - now;
    const bool stepped = present - offset_ > kStep || offset_ - present > kStep;
    if (!known_ || stepped || now - measured_ > kRefresh) measure();
    return std::min(wall - offset_, now);
  }

 private:
  static constexpr Timestamp kRefresh = std::chrono::seconds(1);
  static constexpr Timestamp kStep = std::chrono::microseconds(500);  // no jitter: clock was set

  /// Reads one clock between two readings of the other; the shortest of five tries counts.
  void measure() noexcept {
    Timestamp best = Timestamp::max();
    for (int i = 0; i < 5; ++i) {
      const Timestamp before = read_clock(CLOCK_MONOTONIC);
      const Timestamp wall = read_clock(CLOCK_REALTIME);
      const Timestamp after = read_clock(CLOCK_MONOTONIC);
      if (after - before >= best) continue;
      best = after - before;
      offset_ = wall - before - best / 2;
      measured_ = after;
    }
    known_ = true;
  }

  Timestamp offset_{0};
  Timestamp measured_{0};
  bool known_ = false;
};

struct KernelNotes {
  Timestamp wall_time{0};  ///< arrival, UTC since 1970; now if the kernel says nothing
  std::optional<std::uint32_t> dropped;  ///< since the socket was opened; told only after a drop
};

/// Of a message that recvmsg() filled, from a socket with SO_TIMESTAMPNS and SO_RXQ_OVFL.
[[nodiscard]] inline KernelNotes read_kernel_notes(msghdr& message) noexcept {
  KernelNotes notes;
  for (cmsghdr* c = CMSG_FIRSTHDR(&message); c != nullptr; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET) continue;
    if (c->cmsg_type == SCM_TIMESTAMPNS) {
      timespec t{};
      std::memcpy(&t, CMSG_DATA(c), sizeof t);
      notes.wall_time = std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
    } else if (c->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t dropped = 0;
      std::memcpy(&dropped, CMSG_DATA(c), sizeof dropped);
      notes.dropped = dropped;
    }
  }
  if (notes.wall_time == Timestamp{0}) notes.wall_time = read_clock(CLOCK_REALTIME);
  return notes;
}

/// Room for the notes of one message: give it to recvmsg() as msg_control.
struct KernelNotesRoom {
  alignas(cmsghdr) char bytes[128];
};

}  // namespace isograsp
