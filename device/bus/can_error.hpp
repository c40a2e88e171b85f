// SPDX-License-Identifier: GPL-3.0-or-later
// What an error frame of the kernel says, in the words of BusEvent.
#pragma once

#include <optional>

#include "device/bus/bus.hpp"

namespace isograsp {

struct CanErrorNews {
  /// error_warning, error_passive, error_active, bus_off or restarted: the worst that the frame
  /// names, whether its receive or its transmit counter is the reason.
  std::optional<BusEvent> state;
  /// The controller lost frames that it received, or that it was given to send.
  bool overflow = false;
};

/// No news: a disturbed frame on the wire, a missing acknowledgement, a transmission that took too
/// long. The bus goes on; such frames are counted.
/// @pre frame.error
[[nodiscard]] CanErrorNews read_can_error(const BusFrame& frame) noexcept;

}  // namespace isograsp
