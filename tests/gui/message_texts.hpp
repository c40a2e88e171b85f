// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the layers below as the windows show them: what is wrong, what to do about it,
// and what devices and recordings are called.
#pragma once

#include <set>
#include <string>

namespace isograsp::gui {

/// %1, %2 … stand for what a message names.
[[nodiscard]] std::set<std::string> texts_of_messages(const std::string& source_folder);

/// Those whose places take any words: the file of patterns of the windows.
[[nodiscard]] std::set<std::string> patterns_of_messages(const std::string& source_folder);

}  // namespace isograsp::gui
