// SPDX-License-Identifier: GPL-3.0-or-later
// The languages of the windows. A window built after speak() stands in that language; one that
// stands already is built anew by its owner. Main thread.
#pragma once

#include <string>

#include "languages/languages.hpp"

namespace isograsp::gui {

/// Texts, numbers and dates on the screen from now on; files never change with it. A code that is
/// not in languages::kLanguages means languages::kDesktopLanguage. Needs a QApplication.
void speak(const std::string& code);

/// What the layers below say, in the language that speak() settled on; its numbers and days have
/// the forms of the desktop's country. Main thread.
[[nodiscard]] const Language& spoken_language();

/// The code that speak() settled on; "en" before.
[[nodiscard]] std::string spoken();

}  // namespace isograsp::gui
