// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time.hpp"

#include <cerrno>
#include <ctime>

namespace isograsp {

std::string utc_text(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::optional<std::time_t> time_of_utc(const std::string& text) {
  std::tm parts{};
  const char* const end = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  if (end == nullptr || *end != '\0') return std::nullopt;
  return timegm(&parts);
}

Timestamp SteadyClock::now() const noexcept {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return std::chrono::seconds{t.tv_sec} + std::chrono::nanoseconds{t.tv_nsec};
}

void SteadyClock::wait_until(Timestamp t) noexcept {
  constexpr std::int64_t kNanosecondsPerSecond = 1'000'000'000;
  timespec until{};
  until.tv_sec = t.count() / kNanosecondsPerSecond;
  until.tv_nsec = t.count() % kNanosecondsPerSecond;
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace isograsp
