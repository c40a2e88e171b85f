// SPDX-License-Identifier: GPL-3.0-or-later
// The lines between a computer and a serial CAN adapter (LAWICEL protocol, as the kernel's slcan
// driver speaks it): commands and frames to the adapter, frames, states and errors from it. Text
// only: no I/O, no clock, no allocation.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

#include "device/bus/frame.hpp"

namespace isograsp {

/// A line with its end.
class SlcanText {
 public:
  void add(char c) noexcept { characters_[size_++] = c; }
  void add(std::string_view text) noexcept {
    for (const char c : text) add(c);
  }
  [[nodiscard]] std::string_view view() const noexcept { return {characters_.data(), size_}; }

 private:
  std::array<char, 32> characters_{};  // the longest: T, 8 digits, length, 16 digits, end
  std::size_t size_ = 0;
};

/// What the computer wants of the adapter.
struct SlcanCommand {
  enum class Kind : std::uint8_t { frame, bit_rate, open, listen, close, read_flags };
  Kind kind = Kind::frame;
  BusFrame frame;
  unsigned bit_rate = 0;  ///< [bit/s]
};
/// Reads a line without its end. nullopt: it is malformed, or the adapter has no such command.
[[nodiscard]] std::optional<SlcanCommand> parse_slcan(std::string_view line) noexcept;

/// t, T, r or R. @pre !frame.error, frame.length <= 8
[[nodiscard]] SlcanText format_slcan(const BusFrame& frame) noexcept;

enum class SlcanState : char { active = 'a', warning = 'w', passive = 'p', bus_off = 'b' };
/// The state of the controller and its error counters, 0 … 256.
[[nodiscard]] SlcanText format_slcan_state(SlcanState state, unsigned receive_errors,
                                           unsigned transmit_errors) noexcept;

enum class SlcanError : char {
  acknowledgement = 'a',
  bit = 'b',
  receive_overflow = 'o',
  transmit_overflow = 'O'
};
[[nodiscard]] SlcanText format_slcan_error(SlcanError error) noexcept;

/// What the adapter answers to a command; nothing: the line was not understood.
[[nodiscard]] SlcanText format_slcan_answer(const std::optional<SlcanCommand>& command) noexcept;

/// Cuts a stream of characters into lines. A line that is too long for the protocol is malformed
/// as a whole: it comes out cut to the longest.
class SlcanLines {
 public:
  /// The line that `c` completes, without its end; valid until the next call.
  [[nodiscard]] std::optional<std::string_view> take(char c) noexcept {
    if (c == '\r') return std::string_view(line_.data(), std::exchange(size_, 0));
    if (size_ < line_.size()) line_[size_++] = c;
    return std::nullopt;
  }

 private:
  std::array<char, 28> line_{};  // one more than any line: a cut line is never valid
  std::size_t size_ = 0;
};

}  // namespace isograsp
