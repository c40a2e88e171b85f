// SPDX-License-Identifier: GPL-3.0-or-later
// Merging is SQL on two attached files, `main` and `other`. temp.numbers holds, for every row of
// the other file, its number there and here, and whether it is added. Here: which tables there are,
// and how a row is named. The steps throw as SOCI does. Inside storage/ only.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "storage/care/merge.hpp"

namespace soci {
class session;
}

namespace isograsp::storage {

/// A column that holds the number of a row of another table.
struct MergeReference {
  std::string_view column;
  std::string_view table;
};
using MergeReferences = std::array<MergeReference, 3>;
struct MergeTable {
  std::string_view name;
  std::string_view key;  ///< what tells rows apart; empty: all of their content
  MergeReferences references;
  /// Columns that are filled in after the row was made. While the first is NULL or empty they say
  /// nothing, and what the other file knows is taken.
  std::array<std::string_view, 2> late{};

  /// The column that numbers its rows.
  [[nodiscard]] std::string id() const { return key == "patient_id" ? "patient_id" : "id"; }
};
/// In an order in which nothing refers to what comes later. Patients come before all of them,
/// parts after them.
[[nodiscard]] std::span<const MergeTable> merge_tables();

/// A table whose rows belong to one row of another, have no number of their own and are copied with
/// it.
struct MergePart {
  std::string_view name;
  std::string_view key;  ///< the column with the number of the row that they belong to
  MergeReferences references;
  bool is_content;  ///< where that row is in both files, they must say the same (signals: by hash)
  [[nodiscard]] std::string_view owner() const {
    for (const MergeReference& reference : references)
      if (reference.column == key) return reference.table;
    return {};
  }
};
/// In an order in which nothing refers to what comes later.
[[nodiscard]] std::span<const MergePart> merge_parts();

[[nodiscard]] std::vector<std::string> columns_of(soci::session& sql, std::string_view table);
[[nodiscard]] std::string joined(const std::vector<std::string>& parts, const std::string& between);
/// SQL: the number here of the row of `table` whose number there is `expression`.
[[nodiscard]] std::string number_here(std::string_view table, const std::string& expression);
/// SQL: the column of row `row` of the other file as it is to stand here.
[[nodiscard]] std::string column_here(const MergeReferences& references, const std::string& column,
                                      const std::string& row = "o");
/// SQL: one text of the rows of a part in `file` (main, other) that belong to the row with number
/// `id`, an expression there; numbers in it are those of main.
[[nodiscard]] std::string content_of_part(soci::session& sql, const MergePart& part,
                                          const std::string& file, const std::string& id);
/// SQL: row `row` knows its late columns.
[[nodiscard]] std::string is_told(const MergeTable& table, const std::string& row);

// The steps, in their order.
/// Who is who; people of the other file that are not here are added.
void merge_people(soci::session& sql, std::span<const std::string> same_patients,
                  MergeReport& report);
/// Every row of the other file gets the number of the row with the same key here, else the next
/// free one.
void number_rows(soci::session& sql, const MergeTable& table);
/// Rows that are the same by their key must have the same content. `links_missing`: the other file
/// does not know what its sessions resume.
void find_conflicts(soci::session& sql, const MergeTable& table, bool links_missing,
                    MergeReport& report);
/// The same of the parts of such rows.
void find_conflicts_of_parts(soci::session& sql, MergeReport& report);
/// Added rows that cannot stand beside those that are here.
void find_collisions(soci::session& sql, MergeReport& report);
void copy_rows(soci::session& sql, const MergeTable& table);
/// What only the other file knows of rows that are in both.
void take_late_columns(soci::session& sql, const MergeTable& table);
/// What belongs to the rows that are added.
void copy_parts(soci::session& sql);

}  // namespace isograsp::storage
