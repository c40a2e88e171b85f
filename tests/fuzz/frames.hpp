// SPDX-License-Identifier: GPL-3.0-or-later
// Frames out of the input of a fuzz target.
#pragma once

#include "device/bus/frame.hpp"
#include "tests/fuzz/support.hpp"

namespace isograsp::fuzz {

/// A data frame with this identifier and the next bytes of the input. One in sixteen has another
/// length and may be extended, remote or an error frame.
inline BusFrame take_frame(Numbers& in, std::uint32_t id, std::uint8_t length) noexcept {
  const std::uint8_t shape = in.byte();
  BusFrame frame;
  frame.id = id;
  frame.length = length;
  if (shape >= 0xF0) {
    frame.length = in.byte() % 9;
    frame.extended = (shape & 1) != 0;
    frame.remote = (shape & 2) != 0;
    frame.error = (shape & 4) != 0;
  }
  const auto bytes = in.bytes(frame.length);
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  return frame;
}

/// 0 … 255 steps of 20 us, or, for odd bytes, of 2 ms: within a sample and between samples.
inline Timestamp take_pause(Numbers& in) noexcept {
  const int steps = in.byte();
  return std::chrono::microseconds(steps % 2 == 0 ? steps * 20 : steps * 2000);
}

}  // namespace isograsp::fuzz
