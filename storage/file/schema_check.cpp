// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/schema_check.hpp"

#include <set>
#include <string>
#include <tuple>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/file/open_mode.hpp"
#include "storage/file/schema.hpp"

namespace isograsp::storage {

namespace {

/// Type, name, table, statement: all of a row of sqlite_schema but where it begins.
using SchemaRow = std::tuple<std::string, std::string, std::string, std::string>;

std::set<SchemaRow> schema_of(soci::session& sql) {
  std::set<SchemaRow> all;
  std::string type;
  std::string name;
  std::string table;
  std::string text;
  soci::statement select =
      (sql.prepare << "SELECT type, name, tbl_name, coalesce(sql, '') FROM "
                      "main.sqlite_schema",
       soci::into(type), soci::into(name), soci::into(table), soci::into(text));
  select.execute();
  while (select.fetch()) all.emplace(type, name, table, text);
  return all;
}

/// Of a new file, with the indexes that SQLite makes by itself.
const std::set<SchemaRow>& our_schema() {
  static const std::set<SchemaRow> ours = [] {
    soci::session memory(soci::sqlite3, ":memory:");
    for (const std::string& statement : schema::statements()) memory << statement;
    return schema_of(memory);
  }();
  return ours;
}

/// It holds one session and where that belongs, and nobody logs in to it: no clinic's file is that.
bool is_emergency_file(soci::session& sql) {
  int origins = 0;
  int sessions = 0;
  int slots = 0;
  sql << "SELECT count(*) FROM main.emergency_origin", soci::into(origins);
  sql << "SELECT count(*) FROM main.sessions", soci::into(sessions);
  sql << "SELECT count(*) FROM main.key_slots", soci::into(slots);
  return origins == 1 && sessions <= 1 && slots == 0;
}

}  // namespace

std::vector<Text> schema_problems(soci::session& sql, int format) {
  const std::set<SchemaRow>& ours = our_schema();
  const std::set<SchemaRow> there = schema_of(sql);
  const bool is_old = format < kDatabaseFormat;
  std::vector<Text> problems;
  for (const SchemaRow& row : there) {
    const auto& [type, name, table, text] = row;
    if (!is_old && text == schema::kEmergencyOrigin && is_emergency_file(sql)) continue;
    if ((!is_old || type == "trigger") && !ours.contains(row))
      problems.push_back("sqlite_schema: %1 was not made by isograsp"_text(name));
  }
  if (is_old) return problems;
  for (const SchemaRow& row : ours) {
    if (there.contains(row)) continue;
    const auto& [type, name, table, text] = row;
    const std::string head = text.empty() ? name : text.substr(0, text.find_first_of("(\n"));
    problems.push_back("sqlite_schema: \"%1\" is missing or was changed"_text(head));
  }
  return problems;
}

}  // namespace isograsp::storage
