// SPDX-License-Identifier: GPL-3.0-or-later
// Numbering and copying the rows of a table.
#include <utility>

#include <soci/soci.h>

#include "storage/care/merge_tables.hpp"

namespace isograsp::storage {

namespace {

/// What belongs to a trial and never changes: copied with it.
constexpr std::array<std::string_view, 3> kSignalTables{"signal_groups", "signal_blocks",
                                                        "signal_packs"};

/// All of a row but its own number, as text. quote() tells every value from every other.
std::string content(const std::vector<std::string>& columns, const MergeTable* translate_by) {
  std::vector<std::string> parts;
  for (const auto& column : columns)
    if (column != "id")
      parts.push_back(
          "quote(" + (translate_by != nullptr ? translated(*translate_by, column) : "o." + column) +
          ")");
  return joined(parts, " || ',' || ");
}

/// Equal rows of one file are the first, the second … of them.
std::string keyed(const std::string& file, const MergeTable& table, const std::string& id,
                  const std::string& key) {
  return "SELECT id, key, row_number() OVER (PARTITION BY key ORDER BY id) AS nth FROM (SELECT "
         "o." +
         id + " AS id, " + key + " AS key FROM " + file + "." + std::string(table.name) + " o)";
}

std::pair<std::string, std::string> names_and_values(const MergeTable& table,
                                                     const std::vector<std::string>& columns) {
  std::vector<std::string> values;
  for (const auto& column : columns)
    values.push_back(column == "id" ? "n.here" : translated(table, column));
  return {joined(columns, ", "), joined(values, ", ")};
}

}  // namespace

void number_rows(soci::session& sql, const MergeTable& table) {
  const std::string name(table.name);
  const auto columns = columns_of(sql, table.name);
  const std::string column(table.key);
  const std::string their_key =
      column.empty() ? content(columns, &table) : translated(table, column);
  const std::string our_key = column.empty() ? content(columns, nullptr) : "o." + column;
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
  const auto [names, values] = names_and_values(table, columns_of(sql, table.name));
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

void copy_signals(soci::session& sql) {
  for (const auto table : kSignalTables) {
    const MergeTable of_trial{table, "", {{{"trial_id", "trials"}, {}, {}}}};
    const auto [names, values] = names_and_values(of_trial, columns_of(sql, table));
    sql << "INSERT INTO main." + std::string(table) + " (" + names + ") SELECT " + values +
               " FROM other." + std::string(table) +
               " o JOIN temp.numbers n ON n.name = 'trials' AND n.there = o.trial_id AND n.added "
               "ORDER BY o.rowid";
  }
}

}  // namespace isograsp::storage
