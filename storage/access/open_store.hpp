// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a session store: on SQLite, with the rules of access around it.
#pragma once

#include <memory>
#include <string>

#include "core/result.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/records/session_store.hpp"

namespace isograsp::storage {

/// A file that is not ours, newer than this program (unless read_only) or not writable is refused
/// with the reason. Trials left running by a program that ended are marked interrupted, unless
/// read_only or another program has the file open. Scratch files are removed by who made them.
[[nodiscard]] Result<std::unique_ptr<SessionStore>> open_store(const std::string& path,
                                                               OpenMode how);
/// For reading: like `existing` where the file can be written, so that trials left running are
/// marked; else read_only. Files of older formats are read as they are.
[[nodiscard]] Result<std::unique_ptr<SessionStore>> open_store_to_read(const std::string& path);

}  // namespace isograsp::storage
