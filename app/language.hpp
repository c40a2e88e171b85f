// SPDX-License-Identifier: GPL-3.0-or-later
// The language in which commands speak to people: that of --language, else the one that the clinic
// has set in the windows, else the desktop's. Columns, keys, files and --json stay English.
#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"

namespace isograsp::app {

/// English before choose_language().
[[nodiscard]] const Language& spoken();
/// The text in that language.
[[nodiscard]] std::string spoken(const Text& text);

/// Takes `--language CODE` or `--language=CODE` out of the words of the command line, wherever it
/// stands before a "--", and sets what spoken() answers. Errors: a code that there is not.
[[nodiscard]] Result<void> choose_language(std::vector<const char*>& words);

}  // namespace isograsp::app
