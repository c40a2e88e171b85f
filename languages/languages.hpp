// SPDX-License-Identifier: GPL-3.0-or-later
// The languages in which texts can be said (core/text.hpp), compiled into the program. What each
// says stands in languages/<code>.po.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/text.hpp"

namespace isograsp::languages {

struct LanguageName {
  const char* code;  ///< ISO 639-1
  const char* name;  ///< in the language itself, UTF-8
};
/// In the order in which they are offered.
inline constexpr std::array<LanguageName, 3> kLanguages{
    {{"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}}};

/// Instead of a code: as the desktop has it.
inline constexpr const char* kDesktopLanguage = "system";

[[nodiscard]] bool is_language(std::string_view code) noexcept;

/// Of a code in kLanguages; English for every other one. Lives as long as the program. Any thread.
[[nodiscard]] const Language& language(std::string_view code);

/// The first language of the environment (LANGUAGE, LC_ALL, LC_MESSAGES, LANG) that is there;
/// English if none is.
[[nodiscard]] std::string desktop_language();

}  // namespace isograsp::languages
