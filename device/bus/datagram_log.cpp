// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/datagram_log.hpp"

#include <algorithm>
#include <utility>

#include "device/bus/log_line.hpp"

namespace isograsp {

namespace {

constexpr std::size_t kLongestDatagram = 65507;  // of IPv4
constexpr Words kDatagramLineShape =
    "write lines as (1700000000.001000) 192.168.1.1:49152 00000001 with the bytes in hexadecimal"_text;

Error bad_datagram_line(std::string field, Text what) {
  constexpr std::size_t kLongestField = 60;
  if (field.size() > kLongestField) field = field.substr(0, kLongestField) + "...";
  return refused(std::move(what), kDatagramLineShape).about(std::move(field));
}

}  // namespace

Result<std::optional<DatagramEntry>> parse_datagram_line(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  const auto time = take_word(line);
  if (time.empty()) return std::optional<DatagramEntry>();

  DatagramEntry entry;
  if (time.size() < 2 || time.front() != '(' || time.back() != ')')
    return bad_datagram_line(std::string(time),
                             "the line does not begin with a time in parentheses"_text);
  entry.time_text = time.substr(1, time.size() - 2);
  const auto wall_time = parse_log_time(entry.time_text);
  if (!wall_time)
    return bad_datagram_line(entry.time_text,
                             "not a time in seconds with 6 or 9 fraction digits"_text);
  entry.wall_time = *wall_time;

  const auto address = take_word(line);
  const auto from = parse_endpoint(address);
  if (!from) return bad_datagram_line(std::string(address), "not an IPv4 address with a port"_text);
  entry.from = *from;

  const auto digits = take_word(line);
  if (digits.empty())
    return bad_datagram_line("bytes", "the line ends before the bytes of the datagram"_text);
  if (digits.size() % 2 != 0 || digits.size() / 2 > kLongestDatagram)
    return bad_datagram_line(std::string(digits), "not whole bytes of two hexadecimal digits"_text);
  entry.bytes.reserve(digits.size() / 2);
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const auto byte = parse_hex_byte(digits.substr(i, 2));
    if (!byte)
      return bad_datagram_line(std::string(digits),
                               "not whole bytes of two hexadecimal digits"_text);
    entry.bytes.push_back(*byte);
  }
  if (const auto more = take_word(line); !more.empty())
    return bad_datagram_line(std::string(more), "text after the bytes of the datagram"_text);
  return std::optional(std::move(entry));
}

std::string format_datagram_line(Timestamp wall_time, const Endpoint& from,
                                 std::span<const std::uint8_t> bytes) {
  std::string line = format_log_time(wall_time) + " " + from.text() + " ";
  for (const auto byte : bytes) append_hex_byte(line, byte);
  return line;
}

}  // namespace isograsp
