// SPDX-License-Identifier: GPL-3.0-or-later
// The files of translations as the build has put them into the program. Inside languages/ only.
#pragma once

#include <string_view>

namespace isograsp::languages {

extern const std::string_view kGermanTexts;
extern const std::string_view kFrenchTexts;

}  // namespace isograsp::languages
