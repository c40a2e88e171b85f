// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the database (docs/file_formats.md, "Database"). SI units, named in the columns.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isograsp::storage::schema {

/// "IsoG": tells our files from other SQLite files.
inline constexpr std::int32_t kApplicationId = 0x49736F47;

struct Table {
  const char* name;
  const char* create;
  std::array<const char*, 4> indexes;  ///< statements that make them; null: no more
};
/// All but those of access (storage/file/schema_access.hpp).
[[nodiscard]] std::span<const Table> tables();

/// Statements that make a new file.
[[nodiscard]] std::vector<std::string> statements();

/// An emergency file has it besides: where it belongs.
inline constexpr const char* kEmergencyOrigin =
    "CREATE TABLE emergency_origin (database_path TEXT NOT NULL, database_id TEXT NOT NULL, "
    "reason TEXT NOT NULL) STRICT";

}  // namespace isograsp::storage::schema
