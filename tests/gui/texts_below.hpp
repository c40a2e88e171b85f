// SPDX-License-Identifier: GPL-3.0-or-later
// All texts that the layers below give to the windows: scripts/translations hands them to the
// translators, and a test asks for each of them.
#pragma once

#include <set>
#include <string>

namespace isograsp::gui {

/// As gui/words/texts.hpp looks them up: %1, %2 … stand for numbers, or for what a message names.
/// `library`: the shipped one.
[[nodiscard]] std::set<std::string> texts_below(const std::string& library,
                                                const std::string& source_folder);

}  // namespace isograsp::gui
