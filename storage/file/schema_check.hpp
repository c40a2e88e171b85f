// SPDX-License-Identifier: GPL-3.0-or-later
// Is the schema of a file the one that this program makes? Inside storage/ only.
#pragma once

#include <vector>

#include "core/text.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

/// Each table, index and trigger that is missing, changed or not ours; of an older `format` the
/// triggers alone. Throws as SOCI does.
[[nodiscard]] std::vector<Text> schema_problems(soci::session& sql, int format);

}  // namespace isograsp::storage
