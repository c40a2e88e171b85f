// SPDX-License-Identifier: GPL-3.0-or-later
// What travels in one piece between this computer and a sensor: a CAN frame, a datagram, a piece of
// a serial stream.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/time.hpp"

namespace isograsp {

struct BusFrame {
  /// CAN: the identifier, 11 or 29 bits (of an error frame: its class bits). Elsewhere: the number
  /// of the sensor at the other end, 0 … 2.
  std::uint32_t id = 0;
  /// Bytes in use. A datagram longer than the data has its true length (at most 255) here and its
  /// beginning in `data`.
  std::uint8_t length = 0;
  bool extended = false;  ///< CAN: an identifier of 29 bits
  bool remote = false;    ///< CAN: asks for data, holds none
  bool error = false;     ///< CAN: made by the controller, not by a node
  std::array<std::uint8_t, 64> data{};

  [[nodiscard]] bool operator==(const BusFrame&) const = default;
  /// A data frame with an 11-bit identifier.
  [[nodiscard]] bool is_standard() const noexcept { return !extended && !remote && !error; }
  [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept {
    return std::span(data).first(length < data.size() ? length : data.size());
  }
};

struct ReceivedFrame {
  BusFrame frame;
  Timestamp stamp{0};      ///< arrival, on the clock given to Bus::start()
  Timestamp wall_time{0};  ///< arrival, UTC since 1970; for logs
};

}  // namespace isograsp
