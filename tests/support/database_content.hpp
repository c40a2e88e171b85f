// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a database of the clinic says, as an SQL program reads it.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

namespace isograsp::test {

/// What has no seal by design (docs/file_formats.md, "Hash of a row").
inline const std::set<std::string>& columns_without_seal() {
  static const std::set<std::string> names{"users.pin_failed_count", "key_slots.failed_count",
                                           "key_slots.retry_at_unix_s"};
  return names;
}

/// The first column of each row.
inline std::vector<std::string> lines_of(soci::session& sql, const std::string& query) {
  std::vector<std::string> lines;
  std::string line;
  soci::statement select = (sql.prepare << query, soci::into(line));
  select.execute();
  while (select.fetch()) lines.push_back(line);
  return lines;
}

inline std::vector<std::string> tables_of(soci::session& sql) {
  return lines_of(sql, "SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name");
}
inline std::vector<std::string> columns_of(soci::session& sql, const std::string& table) {
  return lines_of(sql, "SELECT name FROM pragma_table_info('" + table + "') ORDER BY cid");
}

/// The schema and every row of every table, without the columns `left_out`. Throws as SOCI does.
inline std::string content_of_database(
    const std::string& path, const std::set<std::string>& left_out = columns_without_seal()) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\" readonly=true");
  std::string all;
  for (const auto& line :
       lines_of(sql,
                "SELECT type || ' ' || name || ' ' || tbl_name || coalesce(sql, '') "
                "FROM sqlite_schema ORDER BY 1"))
    all += line + "\n";
  for (const auto& table : tables_of(sql)) {
    std::string row;
    for (const auto& column : columns_of(sql, table))
      if (!left_out.contains(table + "." + column))
        row += (row.empty() ? "quote(" : " || ',' || quote(") + column + ")";
    all += table + "\n";
    for (const auto& line :
         lines_of(sql, "SELECT " + row + " AS line FROM " + table + " ORDER BY 1"))
      all += line + "\n";
  }
  return all;
}

}  // namespace isograsp::test
