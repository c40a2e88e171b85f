// SPDX-License-Identifier: GPL-3.0-or-later
// Sentences that a database holds as English text: gui/ looks them up by their words, with %1, %2 …
// for their numbers (gui/words/stored_texts.hpp). Measures and reasons are among them.
#pragma once

#include <set>
#include <string>

namespace isograsp::languages {

/// Of the functions that make them; reasons for a missing value are read from the sources. Throws
/// std::runtime_error if a file cannot be read.
[[nodiscard]] std::set<std::string> sentence_texts(const std::string& source_folder);

}  // namespace isograsp::languages
