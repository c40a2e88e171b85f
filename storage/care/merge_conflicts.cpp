// SPDX-License-Identifier: GPL-3.0-or-later
// What of the other file cannot stand beside what is here.
#include <algorithm>

#include <soci/soci.h>

#include "storage/care/merge_tables.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {

namespace {

/// What a person calls row m.
std::string place(const MergeTable& table) {
  if (table.key == "patient_id")
    return "'the " + std::string(table.name == "restrictions" ? "restriction" : "profile") +
           " of ' || (SELECT code FROM main.patients WHERE id = m.patient_id)";
  if (table.name == "sessions")
    return "'the session of ' || (SELECT code FROM main.patients WHERE id = m.patient_id) || "
           "' that began ' || m.started_utc";
  return "'trial ' || m.number || ' of the session of ' || (SELECT p.code || ' that began ' || "
         "s.started_utc FROM main.sessions s JOIN main.patients p ON p.id = s.patient_id "
         "WHERE s.id = m.session_id)";
}

/// What the signals of trial `row` hash to, packed or not.
std::string content_of(const std::string& row, const std::string& file) {
  return "coalesce(" + row + ".signals_blake2b, (SELECT blake2b FROM temp.hashes WHERE file = '" +
         file + "' AND id = " + row + ".id))";
}

/// One conflict for each row of `query`.
void report_each(soci::session& sql, const std::string& query, MergeReport& report) {
  std::string what;
  soci::statement select = (sql.prepare << query, soci::into(what));
  select.execute();
  while (select.fetch()) report.conflicts.push_back(what);
}

}  // namespace

void find_conflicts(soci::session& sql, const MergeTable& table, bool links_missing,
                    MergeReport& report) {
  if (table.key.empty()) return;
  const std::string name(table.name);
  const auto report_where = [&](const std::string& what, const std::string& differ) {
    report_each(sql,
                "SELECT " + place(table) + " || ' is in both files with different content (" +
                    what + ")' FROM temp.numbers n JOIN other." + name + " o ON o." + table.id() +
                    " = n.there JOIN main." + name + " m ON m." + table.id() +
                    " = n.here WHERE n.name = '" + name + "' AND NOT n.added AND " + differ,
                report);
  };
  for (const auto& column : columns_of(sql, table.name)) {
    if (column == "id" || (links_missing && column == "resumes_id")) continue;
    std::string differ = "m." + column + " IS NOT " + column_here(table.references, column);
    if (column == "signals_blake2b")
      differ = content_of("m", "main") + " IS NOT " + content_of("o", "other");
    if (std::find(table.late.begin(), table.late.end(), column) != table.late.end())
      differ += " AND " + is_told(table, "m") + " AND " + is_told(table, "o");
    report_where(column, differ);
  }
}

void find_conflicts_of_parts(soci::session& sql, MergeReport& report) {
  for (const MergeTable& table : merge_tables()) {
    if (table.key.empty() || table.id() != "id") continue;
    for (const MergePart& part : merge_parts()) {
      if (!part.is_content || part.owner() != table.name) continue;
      const std::string name(table.name);
      report_each(sql,
                  "SELECT " + place(table) + " || ' is in both files with different content (" +
                      std::string(part.name) + ")' FROM temp.numbers n JOIN main." + name +
                      " m ON m.id = n.here WHERE n.name = '" + name + "' AND NOT n.added AND " +
                      content_of_part(sql, part, "main", "n.here") + " IS NOT " +
                      content_of_part(sql, part, "other", "n.there"),
                  report);
    }
  }
}

void find_collisions(soci::session& sql, MergeReport& report) {
  const auto report_rows = [&](const std::string& query) { report_each(sql, query, report); };
  const std::string added = " JOIN temp.numbers n ON n.there = o.id AND n.added AND n.name = ";
  const std::string code = "(SELECT code FROM main.patients WHERE id = m.patient_id)";
  const std::string same_patient = "m.patient_id = " + number_here("patients", "o.patient_id");
  report_rows(
      "SELECT 'the session of ' || (SELECT code FROM main.patients WHERE id = "
      "s.patient_id) || ' that began ' || s.started_utc || ' has another trial ' || "
      "o.number FROM other.trials o" +
      added + "'trials' JOIN main.trials m ON m.number = o.number AND m.session_id = " +
      number_here("sessions", "o.session_id") + " JOIN main.sessions s ON s.id = m.session_id");
  report_rows("SELECT 'primary measure ' || m.measure || ' of ' || " + code +
              " || ' was chosen in both files' FROM other.primary_measures o" + added +
              "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
              " AND m.task_name = o.task_name AND m.hand = o.hand AND m.measure = o.measure AND "
              "m.channel = o.channel");
  report_rows("SELECT " + code + " || ' would have more than " +
              std::to_string(kMostPrimaryMeasures) +
              " primary measures' FROM other.primary_measures o" + added +
              "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
              " GROUP BY m.patient_id HAVING count(DISTINCT o.id) + count(DISTINCT m.id) > " +
              std::to_string(kMostPrimaryMeasures));
  report_rows("SELECT 'stable times of ' || " + code +
              " || ' overlap on ' || max(o.from_date, m.from_date) FROM other.stable_periods o" +
              added + "'stable_periods' JOIN main.stable_periods m ON " + same_patient +
              " AND m.from_date <= o.until_date AND m.until_date >= o.from_date");
  // Measures are made once, with their trial. One file may also hold what a newer version made of
  // the same signals; an older result is never added.
  const std::string same_measure =
      "a.name = b.name AND a.channel = b.channel AND a.unit = b.unit AND a.version < b.version";
  report_rows(
      "SELECT DISTINCT 'trial ' || t.number || ' of the session of ' || (SELECT p.code || "
      "' that began ' || s.started_utc FROM main.sessions s JOIN main.patients p ON p.id = "
      "s.patient_id WHERE s.id = t.session_id) || ' is in both files with different "
      "measures' FROM temp.numbers x JOIN main.trials t ON t.id = x.here "
      "WHERE x.name = 'trials' AND NOT x.added AND (EXISTS (SELECT 1 FROM other.measures b "
      "JOIN temp.numbers n ON n.name = 'measures' AND n.there = b.id AND n.added "
      "WHERE b.trial_id = x.there AND (NOT EXISTS (SELECT 1 FROM main.measures a "
      "WHERE a.trial_id = x.here AND " +
      same_measure +
      ") OR EXISTS (SELECT 1 FROM main.measures a WHERE a.trial_id = x.here AND a.name = b.name "
      "AND a.channel = b.channel AND a.unit = b.unit AND a.version = b.version))) OR "
      "EXISTS (SELECT 1 FROM main.measures b WHERE b.trial_id = x.here AND NOT EXISTS (SELECT 1 "
      "FROM temp.numbers n WHERE n.name = 'measures' AND n.here = b.id AND NOT n.added) AND NOT "
      "EXISTS (SELECT 1 FROM other.measures a WHERE a.trial_id = x.there AND " +
      same_measure + ")))");
}

}  // namespace isograsp::storage
