// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes written in hexadecimal, blanks allowed anywhere.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "device/bus/frame.hpp"
#include "device/bus/log_line.hpp"

namespace isograsp::test {

using Bytes = std::vector<std::uint8_t>;

[[nodiscard]] inline Bytes hex(const std::string& text) {
  Bytes bytes;
  std::string digits;
  for (const char c : text)
    if (c != ' ') digits += c;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    bytes.push_back(parse_hex_byte(std::string_view(digits).substr(i, 2)).value());
  return bytes;
}

[[nodiscard]] inline Bytes bytes_of(const BusFrame& frame) {
  return {frame.bytes().begin(), frame.bytes().end()};
}

}  // namespace isograsp::test
