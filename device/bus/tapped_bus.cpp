// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/tapped_bus.hpp"

#include <utility>

#include "device/bus/kernel_stamp.hpp"

namespace isograsp {

TappedBus::TappedBus(std::unique_ptr<Bus> bus, std::shared_ptr<BusTap> tap)
    : bus_(std::move(bus)), tap_(std::move(tap)) {}

Result<void> TappedBus::start(Clock& clock) {
  clock_ = &clock;
  return bus_->start(clock);
}

bool TappedBus::send(const BusFrame& frame) noexcept {
  const Timestamp now = clock_->now();
  const Timestamp wall_time = clock_->is_virtual() ? now : read_clock(CLOCK_REALTIME);
  const bool taken = bus_->send(frame);
  if (taken) show({frame, now, wall_time, true});
  return taken;
}

BusEvent TappedBus::receive(Timestamp deadline, ReceivedFrame& out) noexcept {
  const BusEvent event = bus_->receive(deadline, out);
  // Other events bring an error frame or nothing.
  if (event == BusEvent::frame || (event != BusEvent::timeout && out.frame.error))
    show({out.frame, out.stamp, out.wall_time, false});
  return event;
}

void TappedBus::show(const TappedFrame& frame) noexcept {
  if (!tap_->ring.push(frame)) tap_->overrun.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace isograsp
