// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/emulator/slcan_codec.hpp"

#include <cassert>

namespace isograsp {

namespace {

constexpr std::string_view kHex = "0123456789ABCDEF";
constexpr char kEndOfLine = '\r';
constexpr char kNotUnderstood = '\a';
constexpr std::array<unsigned, 9> kBitRates{10'000,  20'000,  50'000,  100'000,  125'000,
                                            250'000, 500'000, 800'000, 1'000'000};
constexpr std::size_t kStandardDigits = 3;
constexpr std::size_t kExtendedDigits = 8;
constexpr std::uint32_t kLargestStandard = 0x7FF;
constexpr std::uint32_t kLargestExtended = 0x1FFFFFFF;
constexpr unsigned kLargestLength = 8;

std::optional<std::uint32_t> read_hex(std::string_view digits) noexcept {
  std::uint32_t value = 0;
  for (const char c : digits) {
    const char upper = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
    const auto digit = kHex.find(upper);
    if (digit == std::string_view::npos) return std::nullopt;
    value = value << 4U | static_cast<std::uint32_t>(digit);
  }
  return value;
}

void add_hex(SlcanText& text, std::uint32_t value, std::size_t digits) noexcept {
  for (std::size_t k = digits; k-- > 0;) text.add(kHex[value >> (4 * k) & 0xFU]);
}

void add_decimal(SlcanText& text, unsigned value) noexcept {
  for (const unsigned place : {100U, 10U, 1U})
    text.add(static_cast<char>('0' + value / place % 10U));
}

std::optional<BusFrame> read_frame(std::string_view line) noexcept {
  BusFrame frame;
  frame.extended = line[0] == 'T' || line[0] == 'R';
  frame.remote = line[0] == 'r' || line[0] == 'R';
  const std::size_t digits = frame.extended ? kExtendedDigits : kStandardDigits;
  if (line.size() < 1 + digits + 1) return std::nullopt;
  const auto id = read_hex(line.substr(1, digits));
  const auto length = read_hex(line.substr(1 + digits, 1));
  if (!id || *id > (frame.extended ? kLargestExtended : kLargestStandard)) return std::nullopt;
  if (!length || *length > kLargestLength) return std::nullopt;
  frame.id = *id;
  frame.length = static_cast<std::uint8_t>(*length);
  line.remove_prefix(1 + digits + 1);
  if (line.size() != (frame.remote ? 0U : 2U * frame.length)) return std::nullopt;
  for (std::size_t k = 0; 2 * k < line.size(); ++k) {
    const auto byte = read_hex(line.substr(2 * k, 2));
    if (!byte) return std::nullopt;
    frame.data[k] = static_cast<std::uint8_t>(*byte);
  }
  return frame;
}

}  // namespace

std::optional<SlcanCommand> parse_slcan(std::string_view line) noexcept {
  using Kind = SlcanCommand::Kind;
  if (line == "O") return SlcanCommand{Kind::open, {}, 0};
  if (line == "L") return SlcanCommand{Kind::listen, {}, 0};
  if (line == "C") return SlcanCommand{Kind::close, {}, 0};
  if (line == "F") return SlcanCommand{Kind::read_flags, {}, 0};
  if (line.size() == 2 && line[0] == 'S' && line[1] >= '0' && line[1] <= '8')
    return SlcanCommand{Kind::bit_rate, {}, kBitRates[static_cast<std::size_t>(line[1] - '0')]};
  if (line.empty() || std::string_view("tTrR").find(line[0]) == std::string_view::npos)
    return std::nullopt;
  const auto frame = read_frame(line);
  if (!frame) return std::nullopt;
  return SlcanCommand{Kind::frame, *frame, 0};
}

SlcanText format_slcan(const BusFrame& frame) noexcept {
  assert(!frame.error && frame.length <= kLargestLength);
  SlcanText text;
  const char letter = frame.remote ? 'r' : 't';
  text.add(frame.extended ? static_cast<char>(letter - 'a' + 'A') : letter);
  add_hex(text, frame.id, frame.extended ? kExtendedDigits : kStandardDigits);
  add_hex(text, frame.length, 1);
  if (!frame.remote)
    for (const std::uint8_t byte : frame.bytes()) add_hex(text, byte, 2);
  text.add(kEndOfLine);
  return text;
}

SlcanText format_slcan_state(SlcanState state, unsigned receive_errors,
                             unsigned transmit_errors) noexcept {
  SlcanText text;
  text.add('s');
  text.add(static_cast<char>(state));
  add_decimal(text, receive_errors);
  add_decimal(text, transmit_errors);
  text.add(kEndOfLine);
  return text;
}

SlcanText format_slcan_error(SlcanError error) noexcept {
  SlcanText text;
  text.add("e1");  // one error follows
  text.add(static_cast<char>(error));
  text.add(kEndOfLine);
  return text;
}

SlcanText format_slcan_answer(const std::optional<SlcanCommand>& command) noexcept {
  SlcanText text;
  if (!command) {
    text.add(kNotUnderstood);
    return text;
  }
  if (command->kind == SlcanCommand::Kind::frame) text.add(command->frame.extended ? 'Z' : 'z');
  if (command->kind == SlcanCommand::Kind::read_flags) text.add("F00");
  text.add(kEndOfLine);
  return text;
}

}  // namespace isograsp
