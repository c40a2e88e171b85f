// SPDX-License-Identifier: GPL-3.0-or-later
// The system calls of a raw CAN socket; the rules around them are in socketcan.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "device/bus/frame.hpp"
#include "device/bus/kernel_stamp.hpp"

namespace isograsp {

struct CanSocket {
  int descriptor = -1;
  int failure = 0;  ///< errno of the step that failed, or 0
};
/// Non-blocking, bound to the interface; lets in standard data frames with these identifiers (none:
/// every frame) and every error frame except lost arbitration, with arrival stamps and the number
/// of dropped frames. May allocate.
[[nodiscard]] CanSocket open_can_socket(const std::string& interface,
                                        std::span<const std::uint32_t> ids);

struct CanReading {
  BusFrame frame;
  KernelNotes notes;
  bool from_this_computer = false;  ///< sent by another program here
};
/// Takes what the socket has: 0, or errno (EAGAIN: nothing). Real-time safe.
[[nodiscard]] int read_can_socket(int descriptor, CanReading& out) noexcept;

/// 0, or errno. Real-time safe.
/// @pre frame.length <= 8
[[nodiscard]] int write_can_socket(int descriptor, const BusFrame& frame) noexcept;

}  // namespace isograsp
