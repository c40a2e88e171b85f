// SPDX-License-Identifier: GPL-3.0-or-later
// What the buses of the kernel (SocketCAN, UDP, serial) share: real time, frames that wait a moment
// for room, and counters.
#pragma once

#include <algorithm>
#include <string>

#include "device/bus/bus.hpp"
#include "device/bus/waiting_frames.hpp"

namespace isograsp {

class KernelBus : public Bus {
 public:
  Result<void> start(Clock& clock) override {
    if (clock.is_virtual())
      return refused("a real bus does not run in virtual time"_text,
                     "leave out --fast, or use sim:// or replay://"_text)
          .about(name());
    clock_ = &clock;
    return {};
  }

  bool send(const BusFrame& frame) noexcept override {
    if (waiting_.empty() && write(frame)) return true;
    const Timestamp now = clock_->now();
    if (waiting_.empty()) retry_at_ = now + kRetry;
    return waiting_.push(frame, now);
  }

  BusCounters counters() const noexcept override {
    BusCounters counters = counters_;
    counters.unsent += waiting_.given_up();
    return counters;
  }

 protected:
  /// Time until a full queue is tried again. poll() cannot wait for room: it reports a full queue
  /// as writable, too.
  static constexpr Timestamp kRetry = std::chrono::milliseconds(2);

  /// What errors name.
  [[nodiscard]] virtual std::string name() const = 0;
  /// False if the frame should be tried again later. Real-time safe.
  [[nodiscard]] virtual bool write(const BusFrame& frame) noexcept = 0;

  void send_waiting(Timestamp now) noexcept {
    if (waiting_.empty() || now < retry_at_) return;
    waiting_.leave(now, [this](const BusFrame& frame) { return write(frame); });
    retry_at_ = now + kRetry;
  }
  /// The deadline, or when frames want to be tried again if that is sooner.
  [[nodiscard]] Timestamp sooner(Timestamp deadline) const noexcept {
    return waiting_.empty() ? deadline : std::min(deadline, retry_at_);
  }

  Clock* clock_ = nullptr;
  WaitingFrames waiting_;
  BusCounters counters_;

 private:
  Timestamp retry_at_{0};
};

}  // namespace isograsp
