// SPDX-License-Identifier: GPL-3.0-or-later
// The languages of texts (core/text.hpp), compiled into the program. Their words are in
// languages/<code>.po, those of the windows alone in gui/translations/isograsp_<code>.ts.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::languages {

struct LanguageFacts {
  const char* code;  ///< ISO 639-1
  const char* name;  ///< in the language itself, UTF-8
  char decimal_sign;
  const char* day;  ///< form of a day, made of yyyy, MM and dd
};
/// In the order in which they are offered; English, in which the sources are written, first.
inline constexpr auto kLanguages =
    std::to_array<LanguageFacts>({{"en", "English", '.', "yyyy-MM-dd"},
                                  {"de", "Deutsch", ',', "dd.MM.yyyy"},
                                  {"fr", "Français", ',', "dd/MM/yyyy"}});

/// In place of a code: the language of the desktop.
inline constexpr const char* kDesktopLanguage = "system";

[[nodiscard]] bool is_language(std::string_view code) noexcept;

/// Of a code in kLanguages; English for every other one. Lives as long as the program. Any thread.
[[nodiscard]] const Language& language(std::string_view code);

/// The first language of the environment (LANGUAGE, LC_ALL, LC_MESSAGES, LANG) that is there;
/// English if none is.
[[nodiscard]] std::string desktop_language();

}  // namespace isograsp::languages
