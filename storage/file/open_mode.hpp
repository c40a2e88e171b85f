// SPDX-License-Identifier: GPL-3.0-or-later
// Which files this program writes, and how it may be asked to open one.
#pragma once

namespace isograsp::storage {

/// Format of the files that this program writes (PRAGMA user_version).
inline constexpr int kDatabaseFormat = 10;

enum class OpenMode {
  create,    ///< makes the file if it is absent
  scratch,   ///< like create, but nothing waits for the disk: a power cut may damage the file
  existing,  ///< for writing
  read_only
};

}  // namespace isograsp::storage
