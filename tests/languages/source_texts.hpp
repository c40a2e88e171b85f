// SPDX-License-Identifier: GPL-3.0-or-later
// Every text that the program can say, as the catalogues have to know it.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace isograsp::languages {

/// The words before each _text of a source: literals side by side are one, comments say nothing.
[[nodiscard]] std::set<std::string> texts_in_code(std::string_view code);

/// Those of all folders of the program; names and instructions of the shipped library; what the
/// system says of failures. Words without a letter need no translation and are left out. Throws
/// std::runtime_error if a file cannot be read.
[[nodiscard]] std::set<std::string> all_texts(const std::string& source_folder);

}  // namespace isograsp::languages
