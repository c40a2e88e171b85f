// SPDX-License-Identifier: GPL-3.0-or-later
// A bus made of memory with three emulated sensors on it; receive() drives virtual time.
#pragma once

#include <utility>
#include <vector>

#include "device/bus/bus.hpp"
#include "device/emulator/emulator.hpp"
#include "tests/support/no_alloc.hpp"

namespace isograsp::test {

class EmulatedBus final : public Bus {
 public:
  EmulatedBus(EmulatorOptions options, FingerPlay play)
      : emulator_(std::move(options), std::move(play)) {}

  Result<void> start(Clock& clock) override {
    clock_ = &clock;
    return {};
  }
  bool send(const BusFrame& frame) noexcept override {
    const Uncounted other_end;
    if (log_sent) sent.push_back(frame);
    emulator_.receive(frame, clock_->now());
    return true;
  }
  BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override {
    if (next_event != BusEvent::timeout) return std::exchange(next_event, BusEvent::timeout);
    const Uncounted other_end;
    const Timestamp when = std::max(std::min(deadline, emulator_.next()), clock_->now());
    clock_->wait_until(when);
    if (!emulator_.take(when, out.frame)) return BusEvent::timeout;
    out.stamp = when;
    out.wall_time = when;
    return BusEvent::frame;
  }
  BusCounters counters() const noexcept override { return {}; }

  [[nodiscard]] const Emulator& emulator() const noexcept { return emulator_; }

  bool log_sent = true;
  std::vector<BusFrame> sent;
  BusEvent next_event = BusEvent::timeout;  ///< reported once by the next receive()

 private:
  Emulator emulator_;
  Clock* clock_ = nullptr;
};

}  // namespace isograsp::test
