// SPDX-License-Identifier: GPL-3.0-or-later
// The way to the sensors: frames go out, frames come in with the time of their arrival. Protocols
// see this interface only, so they run on CAN, UDP and serial lines and on a bus made of memory.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"
#include "device/bus/frame.hpp"
#include "hand/finger.hpp"

namespace isograsp {

/// What receive() brought.
enum class BusEvent : std::uint8_t {
  frame,           ///< `out` holds one
  timeout,         ///< the deadline has passed
  error_warning,   ///< the controller counts many errors: the bus still works
  error_passive,   ///< so many that it no longer signals them to other nodes
  error_active,    ///< back to normal
  overflow,        ///< the controller lost frames that came too fast
  bus_off,         ///< the controller switched itself off after errors
  restarted,       ///< it works again after that, or the interface is switched on again
  interface_down,  ///< somebody switched the interface off
  interface_gone   ///< the adapter was unplugged; reopened by name when it is back
};

/// They never decrease.
struct BusCounters {
  std::uint64_t kernel_drops = 0;  ///< frames that nobody read in time
  std::uint64_t overflows = 0;     ///< times that the controller said it lost frames
  std::uint64_t error_frames = 0;  ///< also those without an event: a disturbed frame on the wire
  /// Frames given up: the transmit queue stayed full for 10 ms, or the bus is off, down or gone.
  std::uint64_t unsent = 0;
};

/// Life: open -> start() -> send(), receive()… All calls from one thread.
class Bus {
 public:
  virtual ~Bus() = default;
  /// Stamps are on `clock`, which must outlive the bus. A real bus refuses a virtual clock.
  [[nodiscard]] virtual Result<void> start(Clock& clock) = 0;
  /// Hands a frame to the bus; true does not mean that a node has it. If the bus is busy the frame
  /// waits, at most 10 ms, and leaves from a later receive(). Real-time safe.
  virtual bool send(const BusFrame& frame) noexcept = 0;
  /// Waits for a frame at most until `deadline`. Real-time safe while the interface exists. If an
  /// error frame brought the event, `out` holds it, else out.frame.error is false.
  [[nodiscard]] virtual BusEvent receive(Timestamp deadline, ReceivedFrame& out) noexcept = 0;
  [[nodiscard]] virtual BusCounters counters() const noexcept = 0;
};

/// Opens a CAN interface of the kernel that passes only standard data frames with these
/// identifiers; without identifiers, every frame. Errors name the interface and what to do.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_socketcan(const std::string& interface,
                                                          std::span<const std::uint32_t> ids);

struct CanInterface {
  std::string name;
  bool up = false;
};
/// CAN interfaces of this computer, in alphabetical order.
[[nodiscard]] std::vector<CanInterface> list_can_interfaces();

/// One UDP socket per sensor, connected to "HOST:PORT" (a numeric address): only datagrams of that
/// sensor come in, and BusFrame::id is the sensor's number. Errors name the address.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_udp(
    const std::array<std::string, kFingerCount>& addresses);

/// One serial port per sensor ("/dev/ttyUSB0"), 8N1, without flow control. BusFrame::id is the
/// sensor's number. A frame holds the bytes that the port had, at most 16, so that no frame
/// completes two packets. Errors name the port.
[[nodiscard]] Result<std::unique_ptr<Bus>> open_serial(
    const std::array<std::string, kFingerCount>& ports, unsigned baud);

}  // namespace isograsp
