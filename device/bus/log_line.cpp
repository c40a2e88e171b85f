// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/bus/log_line.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace isograsp {

namespace {

std::optional<std::int64_t> parse_digits(std::string_view text) noexcept {
  const bool digits =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (!digits || failure != std::errc()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Timestamp> parse_log_time(std::string_view text) noexcept {
  constexpr std::size_t kMostWholeDigits = 10;
  const auto dot = text.find('.');
  if (dot == std::string_view::npos || dot > kMostWholeDigits) return std::nullopt;
  const auto fraction = text.substr(dot + 1);
  if (fraction.size() != 6 && fraction.size() != 9) return std::nullopt;
  const auto seconds = parse_digits(text.substr(0, dot));
  const auto parts = parse_digits(fraction);
  constexpr std::int64_t kLastSecond = 9'223'372'035;  // the last in 64 bits of nanoseconds
  if (!seconds || !parts || *seconds > kLastSecond) return std::nullopt;
  return std::chrono::seconds(*seconds) +
         std::chrono::nanoseconds(fraction.size() == 6 ? *parts * 1000 : *parts);
}

std::string format_log_time(Timestamp wall_time) {
  const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(wall_time);
  constexpr std::int64_t kPerSecond = 1'000'000;
  char text[64];
  std::snprintf(text, sizeof text, "(%010lld.%06lld)",
                static_cast<long long>(microseconds.count() / kPerSecond),
                static_cast<long long>(microseconds.count() % kPerSecond));
  return text;
}

std::string_view take_word(std::string_view& text) noexcept {
  constexpr std::string_view kBlank = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(kBlank), text.size()));
  const auto word = text.substr(0, text.find_first_of(kBlank));
  text.remove_prefix(word.size());
  return word;
}

bool is_hex_digit(char c) noexcept {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

std::optional<std::uint8_t> parse_hex_byte(std::string_view digits) noexcept {
  if (digits.size() != 2 || !is_hex_digit(digits[0]) || !is_hex_digit(digits[1]))
    return std::nullopt;
  std::uint8_t byte = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
  return byte;
}

void append_hex_byte(std::string& text, std::uint8_t byte) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  text += kDigits[byte >> 4];
  text += kDigits[byte & 0xF];
}

}  // namespace isograsp
