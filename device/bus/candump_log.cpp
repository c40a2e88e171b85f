// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/candump_log.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "device/bus/log_line.hpp"

namespace isograsp {

namespace {

constexpr std::uint32_t kErrorBit = 0x20000000;
constexpr std::uint32_t kLargestExtendedId = 0x1FFFFFFF;
constexpr std::uint32_t kLargestStandardId = 0x7FF;
constexpr Words kFrameLineShape =
    "write lines as (1700000000.001000) can0 064#0C00000000000000"_text;

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

template <class T>
bool parse_whole(std::string_view text, T& value, int base) noexcept {
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  return failure == std::errc() && end == text.data() + text.size() && !text.empty();
}

/// Bytes of two hexadecimal digits, a '.' allowed between them; at most `most` of them.
bool parse_bytes(std::string_view text, std::size_t most, BusFrame& frame) noexcept {
  std::size_t count = 0;
  while (!text.empty()) {
    if (count > 0 && text.front() == '.') text.remove_prefix(1);
    const auto byte = parse_hex_byte(text.substr(0, 2));
    if (count == most || !byte) return false;
    if (count < frame.data.size()) frame.data[count] = *byte;
    ++count;
    text.remove_prefix(2);
  }
  frame.length = static_cast<std::uint8_t>(std::min(count, frame.data.size()));
  return true;
}

/// What follows the '#' of a classic frame.
bool parse_classic(std::string_view text, BusFrame& frame) noexcept {
  if (!text.empty() && text.front() == 'R') {
    frame.remote = true;
    text.remove_prefix(1);
    if (text.empty()) return true;
    if (!is_digit(text.front()) || text.front() > '8') return false;
    frame.length = static_cast<std::uint8_t>(text.front() - '0');
    text.remove_prefix(1);
    // A raw length code may follow, as below.
    if (text.empty()) return true;
  }
  // Eight bytes may carry a raw length code above 8: _9 … _F.
  if (text.size() >= 2 && text[text.size() - 2] == '_') {
    const char code = text.back();
    if (!is_hex_digit(code) || (is_digit(code) && code != '9')) return false;
    text.remove_suffix(2);
    if (frame.remote) return text.empty() && frame.length == 8;
    return parse_bytes(text, 8, frame) && frame.length == 8;
  }
  return !frame.remote && parse_bytes(text, 8, frame);
}

Result<bool> parse_frame(std::string_view text, CandumpEntry& entry) {
  const auto hash = text.find('#');
  if (hash == std::string_view::npos)
    return refused("a frame without '#'"_text, kFrameLineShape).about(std::string(text));
  const auto digits = text.substr(0, hash);
  std::uint32_t id = 0;
  if ((digits.size() != 3 && digits.size() != 8) ||
      !std::all_of(digits.begin(), digits.end(), is_hex_digit) || !parse_whole(digits, id, 16))
    return refused("an identifier that has neither 3 nor 8 hexadecimal digits"_text,
                   kFrameLineShape)
        .about(std::string(text));
  BusFrame& frame = entry.frame;
  frame = {};
  frame.extended = digits.size() == 8;
  if (frame.extended && (id & kErrorBit) != 0) {
    frame.error = true;
    frame.extended = false;
    id &= ~kErrorBit;
  }
  if (id > (digits.size() == 8 ? kLargestExtendedId : kLargestStandardId))
    return refused("an identifier that is too large"_text, kFrameLineShape)
        .about(std::string(text));
  frame.id = id;

  auto data = text.substr(hash + 1);
  entry.flexible_data_rate = !data.empty() && data.front() == '#';
  if (entry.flexible_data_rate) {
    constexpr std::size_t kMostBytes = 64;
    if (data.size() < 2 || !is_hex_digit(data[1]) ||
        !parse_bytes(data.substr(2), kMostBytes, frame))
      return refused("data of a CAN FD frame that cannot be read"_text, kFrameLineShape)
          .about(std::string(text));
  } else if (!parse_classic(data, frame)) {
    return refused("data that are not up to 8 bytes of two hexadecimal digits"_text,
                   kFrameLineShape)
        .about(std::string(text));
  }
  return true;
}

}  // namespace

Result<std::optional<CandumpEntry>> parse_candump_line(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.empty() || line.front() != '(') return std::optional<CandumpEntry>();

  CandumpEntry entry;
  const auto close = line.find(')');
  if (close == std::string_view::npos)
    return refused("a time without ')'"_text, kFrameLineShape).about("time");
  entry.time_text = line.substr(1, close - 1);
  const auto wall_time = parse_log_time(entry.time_text);
  if (!wall_time)
    return refused("not a time in seconds with 6 or 9 fraction digits"_text, kFrameLineShape)
        .about(entry.time_text);
  entry.wall_time = *wall_time;
  line.remove_prefix(close + 1);

  entry.interface = take_word(line);
  const auto frame = take_word(line);
  if (frame.empty())
    return refused("the line ends before the frame"_text, kFrameLineShape).about("frame");
  if (auto parsed = parse_frame(frame, entry); !parsed) return parsed.error();
  const auto direction = take_word(line);
  if ((!direction.empty() && direction != "R" && direction != "T") || !take_word(line).empty())
    return refused("text after the frame that is not R or T"_text, kFrameLineShape)
        .about(std::string(direction));
  return std::optional(std::move(entry));
}

std::string format_candump_line(Timestamp wall_time, std::string_view interface,
                                const BusFrame& frame) {
  std::string line = format_log_time(wall_time) + " ";
  line += interface;
  char text[32];
  const bool long_id = frame.extended || frame.error;
  std::snprintf(text, sizeof text, long_id ? " %08X#" : " %03X#",
                static_cast<unsigned>(frame.id | (frame.error ? kErrorBit : 0U)));
  line += text;
  if (frame.remote) {
    line += 'R';
    if (frame.length > 0) line += static_cast<char>('0' + frame.length);
    return line;
  }
  for (const auto byte : frame.bytes()) append_hex_byte(line, byte);
  return line;
}

}  // namespace isograsp
