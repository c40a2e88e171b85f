// SPDX-License-Identifier: GPL-3.0-or-later
// What of the other file cannot stand beside what is here.
#include <algorithm>

#include <soci/soci.h>

#include "storage/care/merge_tables.hpp"
#include "storage/records/profile.hpp"

namespace isograsp::storage {

namespace {

/// What stands in the way, as SQL finds it: of whom, and what else the sentence needs.
struct Found {
  std::string code;
  std::string more;   ///< when a session began, or as the query has it
  std::string trial;  ///< number
};

/// The columns of Found for row m.
std::string place_columns(const MergeTable& table) {
  const std::string code = "(SELECT code FROM main.patients WHERE id = m.patient_id)";
  if (table.key == "patient_id") return code + ", '', ''";
  if (table.name == "sessions") return code + ", m.started_utc, ''";
  const auto of_session = [](const std::string& column) {
    return "(SELECT " + column +
           " FROM main.sessions s JOIN main.patients p ON p.id = s.patient_id "
           "WHERE s.id = m.session_id)";
  };
  return of_session("p.code") + ", " + of_session("s.started_utc") + ", '' || m.number";
}

Text trial_words(const Found& found) {
  return "trial %1 of the session of %2 that began %3"_text(found.trial, found.code, found.more);
}

/// What a person calls the row.
Text place_words(const MergeTable& table, const Found& found) {
  if (table.name == "restrictions") return "the restriction of %1"_text(found.code);
  if (table.key == "patient_id") return "the profile of %1"_text(found.code);
  if (table.name == "sessions")
    return "the session of %1 that began %2"_text(found.code, found.more);
  return trial_words(found);
}

/// What the signals of trial `row` hash to, packed or not.
std::string content_of(const std::string& row, const std::string& file) {
  return "coalesce(" + row + ".signals_blake2b, (SELECT blake2b FROM temp.hashes WHERE file = '" +
         file + "' AND id = " + row + ".id))";
}

/// One conflict for each row of `query`, which has the columns of Found.
template <class Words>
void report_each(soci::session& sql, const std::string& query, const Words& words,
                 MergeReport& report) {
  Found found;
  soci::statement select = (sql.prepare << query, soci::into(found.code), soci::into(found.more),
                            soci::into(found.trial));
  select.execute();
  while (select.fetch()) report.conflicts.push_back(words(found));
}

/// Of a row that is in both files.
auto differs_in(const MergeTable& table, const std::string& what) {
  return [&table, what](const Found& found) {
    return "%1 is in both files with different content (%2)"_text(place_words(table, found), what);
  };
}

}  // namespace

void find_conflicts(soci::session& sql, const MergeTable& table, bool links_missing,
                    MergeReport& report) {
  if (table.key.empty()) return;
  const std::string name(table.name);
  const auto report_where = [&](const std::string& what, const std::string& differ) {
    report_each(sql,
                "SELECT " + place_columns(table) + " FROM temp.numbers n JOIN other." + name +
                    " o ON o." + table.id() + " = n.there JOIN main." + name + " m ON m." +
                    table.id() + " = n.here WHERE n.name = '" + name + "' AND NOT n.added AND " +
                    differ,
                differs_in(table, what), report);
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
                  "SELECT " + place_columns(table) + " FROM temp.numbers n JOIN main." + name +
                      " m ON m.id = n.here WHERE n.name = '" + name + "' AND NOT n.added AND " +
                      content_of_part(sql, part, "main", "n.here") + " IS NOT " +
                      content_of_part(sql, part, "other", "n.there"),
                  differs_in(table, std::string(part.name)), report);
    }
  }
}

void find_collisions(soci::session& sql, MergeReport& report) {
  const auto report_rows = [&](const std::string& query, const auto& words) {
    report_each(sql, query, words, report);
  };
  const std::string added = " JOIN temp.numbers n ON n.there = o.id AND n.added AND n.name = ";
  const std::string code = "(SELECT code FROM main.patients WHERE id = m.patient_id)";
  const std::string same_patient = "m.patient_id = " + number_here("patients", "o.patient_id");
  report_rows(
      "SELECT (SELECT code FROM main.patients WHERE id = s.patient_id), s.started_utc, "
      "'' || o.number FROM other.trials o" +
          added + "'trials' JOIN main.trials m ON m.number = o.number AND m.session_id = " +
          number_here("sessions", "o.session_id") + " JOIN main.sessions s ON s.id = m.session_id",
      [](const Found& found) {
        return "the session of %1 that began %2 has another trial %3"_text(found.code, found.more,
                                                                           found.trial);
      });
  report_rows("SELECT " + code + ", m.measure, '' FROM other.primary_measures o" + added +
                  "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
                  " AND m.task_name = o.task_name AND m.hand = o.hand AND m.measure = o.measure "
                  "AND m.channel = o.channel",
              [](const Found& found) {
                return "primary measure %1 of %2 was chosen in both files"_text(found.more,
                                                                                found.code);
              });
  report_rows("SELECT " + code + ", '', '' FROM other.primary_measures o" + added +
                  "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
                  " GROUP BY m.patient_id HAVING count(DISTINCT o.id) + count(DISTINCT m.id) > " +
                  std::to_string(kMostPrimaryMeasures),
              [](const Found& found) {
                return "%1 would have more than %2 primary measures"_text(found.code,
                                                                          kMostPrimaryMeasures);
              });
  report_rows("SELECT " + code + ", max(o.from_date, m.from_date), '' FROM other.stable_periods o" +
                  added + "'stable_periods' JOIN main.stable_periods m ON " + same_patient +
                  " AND m.from_date <= o.until_date AND m.until_date >= o.from_date",
              [](const Found& found) {
                return "stable times of %1 overlap on %2"_text(found.code, found.more);
              });
  // Measures are made once, with their trial. One file may also hold what a newer version made of
  // the same signals; an older result is never added.
  const std::string same_measure =
      "a.name = b.name AND a.channel = b.channel AND a.unit = b.unit AND a.version < b.version";
  report_rows(
      "SELECT DISTINCT p.code, s.started_utc, '' || t.number FROM temp.numbers x "
      "JOIN main.trials t ON t.id = x.here JOIN main.sessions s ON s.id = t.session_id "
      "JOIN main.patients p ON p.id = s.patient_id "
      "WHERE x.name = 'trials' AND NOT x.added AND (EXISTS (SELECT 1 FROM other.measures b "
      "JOIN temp.numbers n ON n.name = 'measures' AND n.there = b.id AND n.added "
      "WHERE b.trial_id = x.there AND (NOT EXISTS (SELECT 1 FROM main.measures a "
      "WHERE a.trial_id = x.here AND " +
          same_measure +
          ") OR EXISTS (SELECT 1 FROM main.measures a WHERE a.trial_id = x.here AND a.name = "
          "b.name "
          "AND a.channel = b.channel AND a.unit = b.unit AND a.version = b.version))) OR "
          "EXISTS (SELECT 1 FROM main.measures b WHERE b.trial_id = x.here AND NOT EXISTS (SELECT "
          "1 "
          "FROM temp.numbers n WHERE n.name = 'measures' AND n.here = b.id AND NOT n.added) AND "
          "NOT "
          "EXISTS (SELECT 1 FROM other.measures a WHERE a.trial_id = x.there AND " +
          same_measure + ")))",
      [](const Found& found) {
        return "%1 is in both files with different measures"_text(trial_words(found));
      });
}

}  // namespace isograsp::storage
