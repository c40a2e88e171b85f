// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the database (docs/file_formats.md, "Database"). SI units, named in the columns.
#pragma once

#include <array>
#include <cstdint>

namespace isograsp::schema {

/// "IsoG": tells our files from other SQLite files.
inline constexpr std::int32_t kApplicationId = 0x49736F47;

/// Statements that make an empty database, in order.
extern const std::array<const char*, 12> kCreate;

}  // namespace isograsp::schema
