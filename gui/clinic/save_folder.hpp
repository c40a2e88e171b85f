// SPDX-License-Identifier: GPL-3.0-or-later
// Where files for people are saved.
#pragma once

#include <QString>
#include <string>

#include "core/result.hpp"

namespace isograsp::gui {

/// The first that exists and may be written into: the folder for documents, the home, that of the
/// database.
[[nodiscard]] QString proposed_folder(const std::string& database);

/// Can a file be made in the folder of `path`? Error: failed, with the folder and what to do.
[[nodiscard]] Result<void> check_folder_of(const std::string& path);

}  // namespace isograsp::gui
