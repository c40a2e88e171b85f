// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the database (docs/file_formats.md, "Database"). SI units, named in the columns.
#pragma once

#include <cstdint>
#include <span>

#include "storage/file/open_mode.hpp"

namespace isograsp::storage::schema {

/// "IsoG": tells our files from other SQLite files.
inline constexpr std::int32_t kApplicationId = 0x49736F47;

/// Statements that make a file of format `format` of one of the format before it; those of format 1
/// make an empty file. A new file is made by all of them in turn, so that it does not differ from
/// one that was brought up to date. @pre 1 <= format <= kDatabaseFormat
[[nodiscard]] std::span<const char* const> statements_to(int format);

}  // namespace isograsp::storage::schema
