// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/hand/wake.hpp"

#include <cerrno>
#include <cstdint>
#include <ctime>
#include <system_error>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

namespace isograsp {

Wake::~Wake() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> Wake::open() {
  if (descriptor_ >= 0) return {};
  descriptor_ = eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  if (descriptor_ >= 0) return {};
  return failed(
      "the system cannot wake a thread: %1"_text(Known{std::system_category().message(errno)}),
      "close other programs and try again"_text);
}

void Wake::signal() const noexcept {
  const std::uint64_t one = 1;
  static_cast<void>(!::write(descriptor_, &one, sizeof one));
}

void Wake::wait(Timestamp span) const noexcept {
  if (span > Timestamp::zero()) {
    pollfd polled{descriptor_, POLLIN, 0};
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(span);
    timespec limit{};
    limit.tv_sec = seconds.count();
    limit.tv_nsec = (span - seconds).count();
    static_cast<void>(ppoll(&polled, 1, &limit, nullptr));
  }
  std::uint64_t signals = 0;
  static_cast<void>(!::read(descriptor_, &signals, sizeof signals));
}

}  // namespace isograsp
