// SPDX-License-Identifier: GPL-3.0-or-later
// How long frames occupy a CAN wire. Bosch CAN 2.0: after five equal bits a sixth of the other kind
// is stuffed in, from the start of the frame to the end of its checksum.
#pragma once

#include <cstdint>
#include <vector>

#include "device/bus/frame.hpp"

namespace isograsp::test {

/// Bits on the wire, with the three of the pause after a frame.
struct WireBits {
  std::uint64_t nominal = 0;  ///< without stuffing
  std::uint64_t real = 0;     ///< with the stuffing of these bytes
  std::uint64_t worst = 0;    ///< with the most stuffing that bytes can need

  WireBits& operator+=(const WireBits& other) noexcept {
    nominal += other.nominal;
    real += other.real;
    worst += other.worst;
    return *this;
  }
};

/// @pre a standard data frame
inline WireBits wire_bits(const BusFrame& frame) {
  constexpr std::uint32_t kPolynomial = 0x4599;
  constexpr std::uint64_t kUnstuffed = 13;  // delimiter, acknowledgement, end, pause
  std::vector<bool> bits;
  const auto add = [&](std::uint32_t value, unsigned count) {
    while (count-- > 0) bits.push_back((value >> count & 1U) != 0);
  };
  add(0, 1);  // start
  add(frame.id, 11);
  add(0, 3);  // data frame, standard, reserved
  add(frame.length, 4);
  for (const std::uint8_t byte : frame.bytes()) add(byte, 8);
  std::uint32_t checksum = 0;
  for (const bool bit : bits) {
    const bool turn = bit != ((checksum >> 14U & 1U) != 0);
    checksum = (checksum << 1U ^ (turn ? kPolynomial : 0U)) & 0x7FFFU;
  }
  add(checksum, 15);
  std::uint64_t stuffed = 0;
  int run = 0;
  bool last = true;  // the pause
  for (const bool bit : bits) {
    run = bit == last ? run + 1 : 1;
    last = bit;
    if (run != 5) continue;
    ++stuffed;  // and it is the first of a new run
    last = !bit;
    run = 1;
  }
  const std::uint64_t data = 8ULL * frame.length;
  return {47 + data, bits.size() + stuffed + kUnstuffed, 47 + data + (33 + data) / 4};
}

}  // namespace isograsp::test
