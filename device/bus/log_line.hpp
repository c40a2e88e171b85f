// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of all raw logs have in common: "(1700000000.001000) …" and bytes in hexadecimal.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace isograsp
