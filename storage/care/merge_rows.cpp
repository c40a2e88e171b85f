// SPDX-License-Identifier: GPL-3.0-or-later
// Numbering and copying the rows of a table.
#include <utility>

#include <soci/soci.h>

#include "storage/care/merge_tables.hpp"

namespace isograsp::storage {

namespace {

/// All of a row but its own number, with its parts, as text. quote() tells every value from every
/// other.
std::string content(soci::session& sql, const MergeTable& table, const std::string& file) {
  std::vector<std::string> parts;
  for (const auto& column : columns_of(sql, table.name))
    if (column != "id")
      parts.push_back("quote(" +
                      (file == "other" ? column_here(table.references, column) : "o." + column) +
                      ")");
  for (const MergePart& part : merge_parts())
    if (part.is_content && part.owner() == table.name)
      parts.push_back(content_of_part(sql, part, file, "o.id"));
  return joined(parts, " || ',' || ");
}

/// Equal rows of one file are the first, the second … of them.
std::string keyed(const std::string& file, const MergeTable& table, const std::string& id,
                  const std::string& key) {
  return "SELECT id, key, row_number() OVER (PARTITION BY key ORDER BY id) AS nth FROM (SELECT "
         "o." +
         id + " AS id, " + key + " AS key FROM " + file + "." + std::string(table.name) + " o)";
}

std::pair<std::string, std::string> names_and_values(const MergeReferences& references,
                                                     const std::vector<std::string>& columns) {
  std::vector<std::string> values;
  for (const auto& column : columns)
    values.push_back(column == "id" ? "n.here" : column_here(references, column));
  return {joined(columns, ", "), joined(values, ", ")};
}

}  // namespace

void number_rows(soci::session& sql, const MergeTable& table) {
  const std::string name(table.name);
  const std::string column(table.key);
  const std::string their_key =
      column.empty() ? content(sql, table, "other") : column_here(table.references, column);
  const std::string our_key = column.empty() ? content(sql, table, "main") : "o." + column;
  const std::string id = table.id();
  sql << "CREATE TEMP TABLE theirs AS " + keyed("other", table, id, their_key);
  sql << "CREATE TEMP TABLE ours AS " + keyed("main", table, id, our_key);
  sql << "CREATE INDEX temp.ours_by_key ON ours (key, nth)";
  sql << "INSERT INTO temp.numbers SELECT '" + name +
             "', t.id, u.id, 0 FROM temp.theirs t JOIN temp.ours u ON u.key = t.key "
             "AND u.nth = t.nth";
  // A profile has the number of its patient; all else the next free one, in the order there.
  const std::string next = id == "patient_id" ? number_here("patients", "t.id")
                                              : "(SELECT coalesce(max(id), 0) FROM main." + name +
                                                    ") + row_number() OVER "
                                                    "(ORDER BY t.id)";
  sql << "INSERT INTO temp.numbers SELECT '" + name + "', t.id, " + next +
             ", 1 FROM temp.theirs t WHERE NOT EXISTS (SELECT 1 FROM temp.numbers n "
             "WHERE n.name = '" +
             name + "' AND n.there = t.id)";
  sql << "DROP TABLE temp.theirs";
  sql << "DROP TABLE temp.ours";
}

void copy_rows(soci::session& sql, const MergeTable& table) {
  const std::string name(table.name);
  const auto [names, values] = names_and_values(table.references, columns_of(sql, table.name));
  sql << "INSERT INTO main." + name + " (" + names + ") SELECT " + values + " FROM other." + name +
             " o JOIN temp.numbers n ON n.name = '" + name + "' AND n.there = o." + table.id() +
             " AND n.added ORDER BY o." + table.id();
}

void take_late_columns(soci::session& sql, const MergeTable& table) {
  std::vector<std::string> values;
  for (const auto late : table.late)
    if (!late.empty()) values.push_back(std::string(late) + " = o." + std::string(late));
  if (values.empty()) return;
  const std::string name(table.name);
  sql << "UPDATE main." + name + " AS m SET " + joined(values, ", ") +
             " FROM temp.numbers n JOIN other." + name + " o ON o.id = n.there WHERE n.name = '" +
             name + "' AND NOT n.added AND n.here = m.id AND " + is_told(table, "o") + " AND NOT " +
             is_told(table, "m");
}

void copy_parts(soci::session& sql) {
  for (const MergePart& part : merge_parts()) {
    const std::string name(part.name);
    const std::string key = "o." + std::string(part.key);
    const auto [names, values] = names_and_values(part.references, columns_of(sql, part.name));
    sql << "INSERT INTO main." + name + " (" + names + ") SELECT " + values + " FROM other." +
               name + " o JOIN temp.numbers n ON n.name = '" + std::string(part.owner()) +
               "' AND n.there = " + key + " AND n.added ORDER BY " + key;
  }
}

}  // namespace isograsp::storage
