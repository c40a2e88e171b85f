// SPDX-License-Identifier: GPL-3.0-or-later
// Wipes removed content from the file and from its log. Inside storage/ only.
#pragma once

#include "storage/file/database.hpp"

namespace isograsp::storage {

/// What this connection removes from now on is overwritten with zeros.
[[nodiscard]] Result<void> overwrite_what_is_removed(Database& database);
/// Writes the file anew without its free pages and empties the log. Fails while another program
/// reads: nothing is lost by trying again.
[[nodiscard]] Result<void> sweep(Database& database);

}  // namespace isograsp::storage
