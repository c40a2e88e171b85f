// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/care/merge_tables.hpp"

#include <soci/soci.h>

namespace isograsp::storage {

namespace {

constexpr std::array<MergeTable, 15> kTables{{
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
    {"instrument_zeros", "", {{{"session_id", "sessions"}, {}, {}}}},
    {"trials",
     "uuid",
     {{{"session_id", "sessions"}, {"zero_id", "instrument_zeros"}, {}}},
     {"zero_drift_N", "zero_drifted"}},
    {"measures", "", {{{"trial_id", "trials"}, {}, {}}}},
    {"events", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"resting_forces", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"ratings", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
}};

}  // namespace

std::span<const MergeTable> merge_tables() {
  return kTables;
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

std::string translated(const MergeTable& table, const std::string& column) {
  for (const MergeReference& reference : table.references)
    if (reference.column == column) return number_here(reference.table, "o." + column);
  return "o." + column;
}

std::string is_told(const MergeTable& table, const std::string& row) {
  // '' differs from every number.
  return "coalesce(" + row + "." + std::string(table.late.front()) + ", '') <> ''";
}

}  // namespace isograsp::storage
