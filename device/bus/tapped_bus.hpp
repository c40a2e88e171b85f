// SPDX-License-Identifier: GPL-3.0-or-later
// A bus that shows its traffic to a second thread: every frame that goes through is copied into a
// ring with its times. For logs of raw frames of any bus, without a second socket.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "core/ring.hpp"
#include "device/bus/bus.hpp"

namespace isograsp {

struct TappedFrame {
  BusFrame frame;
  Timestamp stamp{0};      ///< as ReceivedFrame::stamp; of a sent frame, when send() was called
  Timestamp wall_time{0};  ///< the same moment, UTC since 1970; in virtual time equal to `stamp`
  bool sent = false;       ///< by this program; it may still wait for the bus to be free
};

/// The tap of one bus; the thread that reads it is the ring's one consumer.
struct BusTap {
  explicit BusTap(std::size_t capacity) : ring(capacity) {}
  Ring<TappedFrame> ring;
  std::atomic<std::uint64_t> overrun{0};  ///< frames that found the ring full and are not in it
};

/// As real-time safe as the bus in it: copying never waits.
class TappedBus final : public Bus {
 public:
  /// `tap` may outlive the bus: what it holds can still be read.
  TappedBus(std::unique_ptr<Bus> bus, std::shared_ptr<BusTap> tap);

  Result<void> start(Clock& clock) override;
  bool send(const BusFrame& frame) noexcept override;
  [[nodiscard]] BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept override;
  [[nodiscard]] BusCounters counters() const noexcept override { return bus_->counters(); }

 private:
  void show(const TappedFrame& frame) noexcept;

  std::unique_ptr<Bus> bus_;
  std::shared_ptr<BusTap> tap_;
  Clock* clock_ = nullptr;
};

}  // namespace isograsp
