// SPDX-License-Identifier: GPL-3.0-or-later
// Files of older programs: how they are converted to the present format, and how they are read
// without being changed. Inside storage/ only.
#pragma once

#include <string>
#include <vector>

namespace isograsp::storage::schema {

/// Statements that make a file of format `format` of one of the format before it. Tables are
/// replaced: PRAGMA foreign_keys=OFF and legacy_alter_table=ON, then foreign_key_check.
/// @pre 2 <= format <= kDatabaseFormat
[[nodiscard]] std::vector<std::string> statements_to(int format);

/// Temporary views that show the tables of a file of format `format` as those of today. They stand
/// before the tables of the same name; what the file does not hold is null, empty or 0, as after a
/// migration. Tables that a format does not have at all are not there. Nothing: it is of today.
[[nodiscard]] std::vector<std::string> views_of(int format);

}  // namespace isograsp::storage::schema
