// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/schema_check.hpp"

#include <algorithm>
#include <set>
#include <string>

#include <soci/soci.h>

#include "storage/file/open_mode.hpp"
#include "storage/file/schema.hpp"

namespace isograsp::storage {

std::vector<Text> schema_problems(soci::session& sql, int format) {
  std::set<std::string> missing;
  for (const std::string& statement : schema::statements())
    if (statement.starts_with("CREATE ")) missing.insert(statement);
  std::vector<Text> problems;
  std::string name;
  std::string text;
  // An emergency file says where it belongs in a table of its own.
  const std::string query =
      std::string(
          "SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL AND NOT (type = 'table' AND "
          "name = 'emergency_origin')") +
      (format < kDatabaseFormat ? " AND type = 'trigger'" : "") + " ORDER BY name";
  soci::statement select = (sql.prepare << query, soci::into(name), soci::into(text));
  select.execute();
  while (select.fetch())
    if (missing.erase(text) == 0)
      problems.push_back("sqlite_schema: %1 was not made by isograsp"_text(name));
  if (format < kDatabaseFormat) return problems;
  for (const std::string& statement : missing) {
    const std::string head = statement.substr(0, statement.find_first_of("(\n"));
    problems.push_back("sqlite_schema: \"%1\" is missing or was changed"_text(head));
  }
  return problems;
}

}  // namespace isograsp::storage
