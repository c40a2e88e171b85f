// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of all raw logs have in common: "(1700000000.001000) …" and bytes in hexadecimal.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

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
/// Of two digits; nullopt: they are none.
[[nodiscard]] std::optional<std::uint8_t> parse_hex_byte(std::string_view digits) noexcept;
void append_hex_byte(std::string& text, std::uint8_t byte);

/// Reads a log entry by entry, in constant memory. Parse reads one line without its end; lines that
/// give nullopt are skipped. A line that is longer than any datagram in digits is an error.
template <class Entry, Result<std::optional<Entry>> (*Parse)(std::string_view)>
class LogReader {
 public:
  [[nodiscard]] static Result<LogReader> open(const std::string& path) {
    LogReader reader;
    reader.path_ = path;
    reader.in_.open(path, std::ios::binary);
    if (!reader.in_)
      return Error{
          Error::Code::bad_input, "the log cannot be opened", "check its name", path, 0, ""};
    return reader;
  }
  /// False at the end. Errors name file and line.
  [[nodiscard]] Result<bool> next(Entry& entry) {
    while (in_.getline(text_.data(), static_cast<std::streamsize>(text_.size()))) {
      ++line_;
      const auto count = static_cast<std::size_t>(in_.gcount());  // with the end, if it has one
      auto parsed = Parse(std::string_view(text_.data(), in_.eof() ? count : count - 1));
      if (!parsed) {
        Error error = parsed.error();
        error.file = path_;
        error.line = line_;
        return error;
      }
      if (!parsed->has_value()) continue;
      entry = std::move(**parsed);
      return true;
    }
    if (!in_.bad() && !in_.eof())
      return Error{Error::Code::bad_input,
                   "this line is longer than 256 KiB",
                   "check that it is a log",
                   path_,
                   line_ + 1,
                   ""};
    if (in_.bad())
      return Error{
          Error::Code::failed, "the log cannot be read", "check the disk", path_, line_, ""};
    return false;
  }

 private:
  std::string path_;
  std::ifstream in_;
  std::string text_ = std::string(std::size_t{256} << 10, '\0');
  int line_ = 0;
};

}  // namespace isograsp
