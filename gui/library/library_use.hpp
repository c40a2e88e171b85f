// SPDX-License-Identifier: GPL-3.0-or-later
// Which texts of the library stored trials and sessions used.
#pragma once

#include <string>

#include "gui/library/library_files.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::gui {

/// What is stored of the file with the text `former` that is to become `text`. A trial's task text
/// may go on behind that of the file (level, curve). The thread of `store`.
[[nodiscard]] Result<FileUse> use_of(storage::SessionStore& store, LibraryKind kind,
                                     const std::string& former, const std::string& text);

/// The file may belong to a protocol that is being followed: its trials to come will have the text
/// `former`.
void count_as_used(FileUse& use, LibraryKind kind, const std::string& former,
                   const std::string& text);

}  // namespace isograsp::gui
