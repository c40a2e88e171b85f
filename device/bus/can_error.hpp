// SPDX-License-Identifier: GPL-3.0-or-later
// What an error frame of the kernel says, in the words of BusEvent.
#pragma once

#include <optional>

#include "device/bus/bus.hpp"

namespace isograsp {

struct CanErrorNews {
  /// The worst state that the frame names for the receive or the transmit counter: error_warning,
  /// error_passive, error_active, bus_off or restarted.
  std::optional<BusEvent> state;
  /// The controller lost frames that it received, or that it was given to send.
  bool overflow = false;
};

/// A disturbed frame on the wire, a missing acknowledgement or a transmission that took too long is
/// no news: the bus goes on, and such frames are counted.
/// @pre frame.error
[[nodiscard]] CanErrorNews read_can_error(const BusFrame& frame) noexcept;

}  // namespace isograsp
