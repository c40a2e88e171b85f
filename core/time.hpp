// SPDX-License-Identifier: GPL-3.0-or-later
// One steady clock for everything; a ManualClock drives the whole program in virtual time.
#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <optional>
#include <string>

namespace isograsp {

/// Time since the epoch of the clock in use; nanoseconds.
using Timestamp = std::chrono::nanoseconds;

[[nodiscard]] inline Timestamp from_seconds(double t_s) {
  return Timestamp{std::llround(t_s * 1e9)};
}
[[nodiscard]] inline double to_seconds(Timestamp t) {
  return static_cast<double>(t.count()) * 1e-9;
}

/// Wall time as ISO 8601 in UTC: 2026-03-05T09:30:00Z.
[[nodiscard]] std::string utc_text(std::time_t time);
/// The reverse, for exactly this form.
[[nodiscard]] std::optional<std::time_t> time_of_utc(const std::string& text);

class Clock {
 public:
  virtual ~Clock() = default;
  /// Real-time safe.
  [[nodiscard]] virtual Timestamp now() const noexcept = 0;
  /// Returns at or after `t`; at once if `t` has passed. Real-time safe.
  virtual void wait_until(Timestamp t) noexcept = 0;
  /// True if time moves only by wait_until.
  [[nodiscard]] virtual bool is_virtual() const noexcept = 0;
};

/// CLOCK_MONOTONIC with absolute deadlines.
class SteadyClock final : public Clock {
 public:
  [[nodiscard]] Timestamp now() const noexcept override;
  void wait_until(Timestamp t) noexcept override;
  [[nodiscard]] bool is_virtual() const noexcept override { return false; }
};

/// Virtual time: stands still until somebody waits. Not thread-safe: one thread drives it.
class ManualClock final : public Clock {
 public:
  [[nodiscard]] Timestamp now() const noexcept override { return now_; }
  void wait_until(Timestamp t) noexcept override {
    if (t > now_) now_ = t;
  }
  [[nodiscard]] bool is_virtual() const noexcept override { return true; }

 private:
  Timestamp now_{0};
};

}  // namespace isograsp
