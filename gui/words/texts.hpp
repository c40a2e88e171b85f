// SPDX-License-Identifier: GPL-3.0-or-later
// Texts, numbers and dates of the layers below as they stand on the screen, in the language that
// speak() chose (gui/words/language.hpp). Nothing that is stored or exported goes through here.
#pragma once

#include <QString>
#include <string>
#include <string_view>

#include "core/result.hpp"
#include "core/text.hpp"

namespace isograsp::gui {

/// The same letters as Qt has them.
[[nodiscard]] QString qt(std::string_view text);
/// English words that a database or a file of the library has, such as the name of a task or what
/// an event says: looked up as a whole; what is not known stays as it is.
[[nodiscard]] QString translated(std::string_view english);
/// A text of the layers below in the language of the screen.
[[nodiscard]] QString translated(const Text& text);
/// Error::message() in the language of the screen.
[[nodiscard]] QString translated(const Error& error);

/// Words from the beginning of a sentence as they stand in the middle of one: with a small first
/// letter, except where the language writes nouns with a large one.
[[nodiscard]] QString in_sentence(QString words);

/// "1.25", "1,25".
[[nodiscard]] QString translated_number(double value, int decimals);
/// "−4.20" as "−4,20": digits that a layer below has formed.
[[nodiscard]] QString translated_digits(std::string_view digits);

/// How a day is written: "dd.MM.yyyy". English-speaking countries order day and month in opposite
/// ways, so in English it is year, month, day.
[[nodiscard]] QString date_form();
/// "2026-03-05" as "05.03.2026"; what is no day stays as it is.
[[nodiscard]] QString translated_date(std::string_view iso);

}  // namespace isograsp::gui
