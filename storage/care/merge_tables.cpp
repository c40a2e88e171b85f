// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/care/merge_tables.hpp"

#include <soci/soci.h>

namespace isograsp::storage {

namespace {

constexpr std::array<MergeTable, 14> kMergedTables{{
    {"patient_profiles", "patient_id", {{{"patient_id", "patients"}, {}, {}}}},
    {"treatment_marks", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"clinical_scores", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"primary_measures", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"stable_periods", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"consents", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"restrictions", "patient_id", {{{"patient_id", "patients"}, {}, {}}}},
    {"sessions",
     "uuid",
     {{{"patient_id", "patients"}, {"resumes_id", "sessions"}, {}}},
     {"ended_utc"}},
    {"session_answers", "", {{{"session_id", "sessions"}, {}, {}}}},
    {"trials", "uuid", {{{"session_id", "sessions"}, {}, {}}}},
    {"preparations", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"measures", "", {{{"trial_id", "trials"}, {}, {}}}},
    {"events", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"ratings", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
}};

constexpr std::array<MergePart, 8> kParts{{
    {"session_sensors", "session_id", {{{"session_id", "sessions"}, {}, {}}}, true},
    {"session_references", "session_id", {{{"session_id", "sessions"}, {}, {}}}, true},
    {"trial_references", "trial_id", {{{"trial_id", "trials"}, {}, {}}}, true},
    {"preparation_references",
     "preparation_id",
     {{{"preparation_id", "preparations"}, {}, {}}},
     true},
    {"trial_preparations",
     "trial_id",
     {{{"session_id", "sessions"}, {"trial_id", "trials"}, {"preparation_id", "preparations"}}},
     true},
    {"signal_groups", "trial_id", {{{"trial_id", "trials"}, {}, {}}}, false},
    {"signal_blocks", "trial_id", {{{"trial_id", "trials"}, {}, {}}}, false},
    {"signal_packs", "trial_id", {{{"trial_id", "trials"}, {}, {}}}, false},
}};

}  // namespace

std::span<const MergeTable> merge_tables() {
  return kMergedTables;
}

std::span<const MergePart> merge_parts() {
  return kParts;
}

std::vector<std::string> columns_of(soci::session& sql, std::string_view table) {
  std::vector<std::string> columns;
  std::string name;
  const std::string query =
      "SELECT name FROM pragma_table_info('" + std::string(table) + "') ORDER BY cid";
  soci::statement select = (sql.prepare << query, soci::into(name));
  select.execute();
  while (select.fetch()) columns.push_back(name);
  return columns;
}

std::string joined(const std::vector<std::string>& parts, const std::string& between) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

std::string number_here(std::string_view table, const std::string& expression) {
  return "(SELECT here FROM temp.numbers WHERE name = '" + std::string(table) +
         "' AND there = " + expression + ")";
}

std::string column_here(const MergeReferences& references, const std::string& column,
                        const std::string& row) {
  for (const MergeReference& reference : references)
    if (reference.column == column) return number_here(reference.table, row + "." + column);
  return row + "." + column;
}

std::string content_of_part(soci::session& sql, const MergePart& part, const std::string& file,
                            const std::string& id) {
  std::vector<std::string> values;
  for (const auto& column : columns_of(sql, part.name))
    if (column != part.key)
      values.push_back(
          "quote(" +
          (file == "other" ? column_here(part.references, column, "part") : "part." + column) +
          ")");
  return "coalesce((SELECT group_concat(line, char(10)) FROM (SELECT " +
         joined(values, " || ',' || ") + " AS line FROM " + file + "." + std::string(part.name) +
         " part WHERE part." + std::string(part.key) + " = " + id + " ORDER BY line)), '')";
}

std::string is_told(const MergeTable& table, const std::string& row) {
  // '' differs from every number.
  return "coalesce(" + row + "." + std::string(table.late.front()) + ", '') <> ''";
}

}  // namespace isograsp::storage
