// SPDX-License-Identifier: GPL-3.0-or-later
// One CAN bus: frames go out, frames come in with the time of their arrival. Protocols see this
// interface only, so they run on a real bus (SocketCAN) and on one made of memory.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"

namespace isograsp {

/// A classic CAN frame.
struct CanFrame {
  std::uint32_t id = 0;  ///< 11 or 29 bits; of an error frame: its class bits
  std::uint8_t length = 0;
  bool extended = false;
  bool remote = false;
  bool error = false;  ///< made by the controller, not by a node
  std::array<std::uint8_t, 8> data{};

  [[nodiscard]] bool operator==(const CanFrame&) const = default;
};

/// What receive() brought.
enum class BusEvent : std::uint8_t {
  frame,           ///< `out` holds one
  timeout,         ///< the deadline has passed
  bus_off,         ///< the controller switched itself off after errors
  interface_down,  ///< somebody switched the interface off
  interface_gone   ///< the adapter was unplugged; reopened by name when it is back
};

struct ReceivedFrame {
  CanFrame frame;
  Timestamp stamp{0};      ///< arrival, on the clock given to start()
  Timestamp wall_time{0};  ///< arrival, UTC since 1970; for logs
};

/// Life: open -> start() -> send(), receive()… All calls from one thread.
class CanBus {
 public:
  virtual ~CanBus() = default;
  /// Stamps are on `clock`, which must outlive the bus. A real bus refuses a virtual clock.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  /// Hands a frame to the bus; true does not mean that a node has it. If the bus is busy the frame
  /// waits and leaves from a later receive(). Real-time safe.
  virtual bool send(const CanFrame& frame) noexcept = 0;
  /// Waits for a frame at most until `deadline`. Real-time safe while the interface exists.
  [[nodiscard]] virtual BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept = 0;
  /// Frames that were dropped because nobody read them in time.
  [[nodiscard]] virtual std::uint64_t drops() const noexcept = 0;
};

/// Opens an interface of the kernel and lets only standard data frames with these identifiers in;
/// no identifiers: every frame. Errors name the interface and what to do.
[[nodiscard]] Result<std::unique_ptr<CanBus>> open_socketcan(const std::string& interface,
                                                             std::span<const std::uint32_t> ids);

struct CanInterface {
  std::string name;
  bool up = false;
};
/// CAN interfaces of this computer, in alphabetical order.
[[nodiscard]] std::vector<CanInterface> list_can_interfaces();

}  // namespace isograsp
