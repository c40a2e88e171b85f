// SPDX-License-Identifier: GPL-3.0-or-later
// The time of a recording that is played as if it came now, faster, slower or without waiting.
#pragma once

#include <algorithm>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/config/uri.hpp"

namespace isograsp {

/// The `speed` of a replay URI: 0, or 0.01 to 1000. Refused too: no file is named.
[[nodiscard]] Result<double> replay_speed(const Uri& uri);

/// Time runs on from that of the clock at the start. Real-time safe.
class ReplayClock {
 public:
  /// `speed` 0: nothing is waited for, time is what was read.
  explicit ReplayClock(double speed) noexcept : speed_(speed) {}

  void start(Clock& clock) noexcept {
    clock_ = &clock;
    start_ = reached_ = clock.now();
  }
  void stop() noexcept { clock_ = nullptr; }
  [[nodiscard]] bool runs() const noexcept { return clock_ != nullptr; }
  /// @pre runs()
  [[nodiscard]] Timestamp now() const noexcept { return now(*clock_); }
  [[nodiscard]] Timestamp now(const Clock& clock) const noexcept {
    if (speed_ == 0.0) return reached_;
    return start_ + scaled(clock.now() - start_, speed_);
  }
  /// When what was recorded at this time since its beginning comes.
  [[nodiscard]] Timestamp at(Timestamp recorded) const noexcept { return start_ + recorded; }
  /// Waits until `stamp`, or the deadline if that comes first: false. @pre runs()
  [[nodiscard]] bool wait_for(Timestamp stamp, Timestamp deadline) noexcept {
    const Timestamp until = std::min(stamp, deadline);
    reached_ = std::max(reached_, until);
    if (speed_ > 0.0) clock_->wait_until(start_ + scaled(until - start_, 1.0 / speed_));
    return stamp <= deadline;
  }

 private:
  /// Exact at speed 1.
  [[nodiscard]] static Timestamp scaled(Timestamp span, double factor) noexcept;

  double speed_;
  Clock* clock_ = nullptr;  ///< null: stopped
  Timestamp start_{0};
  Timestamp reached_{0};  ///< recorded time that was waited for
};

}  // namespace isograsp
