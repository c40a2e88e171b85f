// SPDX-License-Identifier: GPL-3.0-or-later
// The languages of the windows. A window built after speak() stands in that language; one that
// stands already is built anew by its owner. Main thread.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gui/words/text_patterns.hpp"

namespace isograsp::gui {

struct Language {
  const char* code;  ///< ISO 639-1
  const char* name;  ///< in the language itself, UTF-8
};
/// In the order in which they are offered. A new one also needs its files (gui/CMakeLists.txt).
inline constexpr std::array<Language, 3> kLanguages{
    {{"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}}};

/// Instead of a code: as the desktop has it.
inline constexpr const char* kDesktopLanguage = "system";

/// The first language of the desktop that is there; English if none is.
[[nodiscard]] std::string desktop_language();

/// Texts, numbers and dates on the screen from now on; files never change with it. A code that is
/// not in kLanguages means kDesktopLanguage. Needs a QApplication.
void speak(const std::string& code);

/// What the layers below say and the languages know with places in it, the longest first
/// (gui/translations/patterns.txt). Any thread.
[[nodiscard]] const std::vector<TextPattern>& patterns_below();

/// The code that speak() settled on; "en" before.
[[nodiscard]] std::string spoken();

}  // namespace isograsp::gui
