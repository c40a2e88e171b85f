// SPDX-License-Identifier: GPL-3.0-or-later
// Inside device/bus/ only. Waits for sockets that come and go, which an io_context would have to be
// told of each time.
#pragma once

#include <array>
#include <ctime>

#include <poll.h>

#include "core/time.hpp"

namespace isograsp {

/// What to wait for; descriptors below 0 are passed over.
struct Awaited {
  int descriptor = -1;
  bool writable = false;  ///< else readable
};

/// Returns when one of them is ready, or after `span`. Real-time safe.
template <std::size_t Count>
void wait_for(const std::array<Awaited, Count>& all, Timestamp span) noexcept {
  if (span <= Timestamp::zero()) return;
  std::array<pollfd, Count> polled{};
  for (std::size_t i = 0; i < Count; ++i) {
    polled[i].fd = all[i].descriptor;
    polled[i].events = all[i].writable ? POLLOUT : POLLIN;
  }
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(span);
  timespec limit{};
  limit.tv_sec = seconds.count();
  limit.tv_nsec = (span - seconds).count();
  static_cast<void>(ppoll(polled.data(), polled.size(), &limit, nullptr));
}

}  // namespace isograsp
