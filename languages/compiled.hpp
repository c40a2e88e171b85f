// SPDX-License-Identifier: GPL-3.0-or-later
// The files of translations as the build has put them into the program. Inside languages/ only.
#pragma once

#include <string_view>

namespace isograsp::languages {

/// What languages/<code>.po holds; empty: there is none.
[[nodiscard]] std::string_view texts_of(std::string_view code);

}  // namespace isograsp::languages
