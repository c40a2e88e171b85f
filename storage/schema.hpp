// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the database (docs/file_formats.md, "Database"). SI units, named in the columns.
#pragma once

#include <array>
#include <cstdint>

namespace isograsp::schema {

/// "IsoG": tells our files from other SQLite files.
inline constexpr std::int32_t kApplicationId = 0x49736F47;

/// Statements that make an empty database of format 1, in order.
extern const std::array<const char*, 12> kCreate;
/// Statements that make a database of format 1 one of format 2. A new file is made by kCreate and
/// this, so that it does not differ from one that was brought up to date.
extern const std::array<const char*, 16> kToFormat2;

}  // namespace isograsp::schema
