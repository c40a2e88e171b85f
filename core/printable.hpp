// SPDX-License-Identifier: GPL-3.0-or-later
// Words from files, made fit for a terminal, a log or a line of a message.
#pragma once

#include <string>
#include <string_view>

namespace isograsp {

/// The same words on one line that cannot move a cursor, change colours or turn the direction of
/// writing: control characters (\n, \t, \x1b …), the bidirectional and line-breaking characters of
/// Unicode (\u202e …) and bytes that are no UTF-8 (\xff) are written out. Everything else, and so
/// every text without them, is unchanged.
[[nodiscard]] std::string printable(std::string_view words);
/// The same for text of several lines: its line ends and tabs stay.
[[nodiscard]] std::string printable_lines(std::string_view text);

}  // namespace isograsp
