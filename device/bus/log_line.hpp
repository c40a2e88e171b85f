// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of all raw logs have in common: "(1700000000.001000) …" and bytes in hexadecimal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/lines.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace isograsp {

/// "1700000000.001000": at most ten digits of seconds since 1970, six or nine of the fraction.
[[nodiscard]] std::optional<Timestamp> parse_log_time(std::string_view text) noexcept;
/// With the parentheses, six fraction digits.
[[nodiscard]] std::string format_log_time(Timestamp wall_time);

/// Cuts the first word off; empty: there is none.
[[nodiscard]] std::string_view take_word(std::string_view& text) noexcept;
[[nodiscard]] bool is_hex_digit(char c) noexcept;
/// A byte from two hexadecimal digits; nullopt if they are not.
[[nodiscard]] std::optional<std::uint8_t> parse_hex_byte(std::string_view digits) noexcept;
void append_hex_byte(std::string& text, std::uint8_t byte);

/// Reads a log entry by entry, in constant memory. Parse reads one line without its end; lines that
/// give nullopt are skipped. A line that is longer than any datagram in digits is an error.
template <class Entry, Result<std::optional<Entry>> (*Parse)(std::string_view)>
class LogReader {
 public:
  [[nodiscard]] static Result<LogReader> open(const std::string& path) {
    constexpr std::size_t kLongestLine = std::size_t{256} << 10;
    constexpr Words kLogRemedy = "check that it is a log"_text;
    auto lines = LineReader::open(path, kLongestLine, kLogRemedy);
    if (!lines) return lines.error();
    return LogReader(std::move(*lines));
  }
  /// False at the end. Errors name file and line.
  [[nodiscard]] Result<bool> next(Entry& entry) {
    for (;;) {
      auto more = lines_.next();
      if (!more || !*more) return more;
      auto parsed = Parse(lines_.text());
      if (!parsed) {
        Error error = parsed.error();
        error.file = lines_.path();
        error.line = lines_.line();
        return error;
      }
      if (!parsed->has_value()) continue;
      entry = std::move(**parsed);
      return true;
    }
  }

 private:
  explicit LogReader(LineReader lines) : lines_(std::move(lines)) {}
  LineReader lines_;
};

}  // namespace isograsp
