// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the other file gets a number here: that of the row with the same UUID or the same
// content, else the next free one. Then the rows with new numbers are copied.
#include "storage/merge.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <string_view>

#include <soci/soci.h>

#include "storage/access.hpp"
#include "storage/audit_chain.hpp"
#include "storage/profile.hpp"
#include "storage/sqlite_store.hpp"

namespace isograsp {

namespace {

/// A column that holds the number of a row of another table.
struct Reference {
  std::string_view column;
  std::string_view table;
};
struct Table {
  std::string_view name;
  std::string_view key;  ///< what tells rows apart; empty: all of their content
  std::array<Reference, 3> references;
};
/// In an order in which nothing refers to what comes later. Patients come before all of them.
constexpr std::array<Table, 15> kTables{{
    {"patient_profiles", "patient_id", {{{"patient_id", "patients"}, {}, {}}}},
    {"treatment_marks", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"clinical_scores", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"primary_measures", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"stable_periods", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"consents", "", {{{"patient_id", "patients"}, {}, {}}}},
    {"restrictions", "patient_id", {{{"patient_id", "patients"}, {}, {}}}},
    {"sessions", "uuid", {{{"patient_id", "patients"}, {"resumes_id", "sessions"}, {}}}},
    {"session_answers", "", {{{"session_id", "sessions"}, {}, {}}}},
    {"instrument_zeros", "", {{{"session_id", "sessions"}, {}, {}}}},
    {"trials", "uuid", {{{"session_id", "sessions"}, {"zero_id", "instrument_zeros"}, {}}}},
    {"measures", "", {{{"trial_id", "trials"}, {}, {}}}},
    {"events", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"resting_forces", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
    {"ratings", "", {{{"session_id", "sessions"}, {"trial_id", "trials"}, {}}}},
}};
/// What belongs to a trial and never changes: copied with it.
constexpr std::array<std::string_view, 3> kSignalTables{"signal_groups", "signal_blocks",
                                                        "signal_packs"};

using Strings = std::vector<std::string>;

Strings columns_of(soci::session& sql, std::string_view table) {
  Strings columns;
  std::string name;
  const std::string query =
      "SELECT name FROM pragma_table_info('" + std::string(table) + "') ORDER BY cid";
  soci::statement select = (sql.prepare << query, soci::into(name));
  select.execute();
  while (select.fetch()) columns.push_back(name);
  return columns;
}

std::string joined(const Strings& parts, const std::string& between) {
  std::string text;
  for (const auto& part : parts) text += (text.empty() ? "" : between) + part;
  return text;
}

/// The number here of the row of `table` whose number there is `expression`.
std::string here(std::string_view table, const std::string& expression) {
  return "(SELECT here FROM temp.numbers WHERE name = '" + std::string(table) +
         "' AND there = " + expression + ")";
}

/// The column of row o of the other file as it is to stand here.
std::string translated(const Table& table, const std::string& column) {
  for (const Reference& reference : table.references)
    if (reference.column == column) return here(reference.table, "o." + column);
  return "o." + column;
}

class Merging {
 public:
  Merging(soci::session& sql, std::span<const std::string> same_patients)
      : sql_(sql), same_patients_(same_patients) {}

  MergeReport run() {
    sql_ << "CREATE TEMP TABLE numbers (name TEXT NOT NULL, there INTEGER NOT NULL, "
            "here INTEGER NOT NULL, added INTEGER NOT NULL, PRIMARY KEY (name, there))";
    number_patients();
    if (!report_.conflicts.empty()) return std::move(report_);
    for (const Table& table : kTables) {
      number_rows(table);
      find_conflicts(table);
    }
    find_collisions();
    if (!report_.conflicts.empty()) return std::move(report_);
    for (const Table& table : kTables) copy_rows(table);
    for (const auto table : kSignalTables) {
      const Table of_trial{table, "", {{{"trial_id", "trials"}, {}, {}}}};
      const auto [names, values] = names_and_values(of_trial, columns_of(sql_, table));
      sql_
          << "INSERT INTO main." + std::string(table) + " (" + names + ") SELECT " + values +
                 " FROM other." + std::string(table) +
                 " o JOIN temp.numbers n ON n.name = 'trials' AND n.there = o.trial_id AND n.added "
                 "ORDER BY o.rowid";
    }
    report_.sessions_added = count("name = 'sessions' AND added");
    report_.trials_added = count("name = 'trials' AND added");
    report_.trials_present = count("name = 'trials' AND NOT added");
    sql_ << "DROP TABLE temp.numbers";
    return std::move(report_);
  }

 private:
  struct Patient {
    RowId id = 0;
    std::string code;
    std::string created_utc;
    std::set<std::string> uuids;
  };

  std::vector<Patient> patients(const std::string& file) {
    std::vector<Patient> all;
    {
      Patient one;
      std::string uuid;
      const std::string query = "SELECT id, code, created_utc, uuid FROM " + file +
                                ".patients "
                                "ORDER BY id";
      soci::statement select = (sql_.prepare << query, soci::into(one.id), soci::into(one.code),
                                soci::into(one.created_utc), soci::into(uuid));
      select.execute();
      while (select.fetch()) {
        one.uuids = {uuid};
        all.push_back(one);
      }
    }
    RowId id = 0;
    std::string alias;
    const std::string query = "SELECT patient_id, uuid FROM " + file + ".patient_aliases";
    soci::statement select = (sql_.prepare << query, soci::into(id), soci::into(alias));
    select.execute();
    while (select.fetch())
      for (Patient& patient : all)
        if (patient.id == id) patient.uuids.insert(alias);
    return all;
  }

  static bool same_code(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
      return std::tolower(x) == std::tolower(y);
    });
  }

  void number_patients() {
    auto ours = patients("main");
    RowId next = 0;
    for (const Patient& patient : ours) next = std::max(next, patient.id);
    std::set<std::string> used;
    for (const Patient& theirs : patients("other")) {
      std::vector<Patient*> known;
      Patient* same = nullptr;
      for (Patient& our : ours) {
        if (std::any_of(theirs.uuids.begin(), theirs.uuids.end(),
                        [&](const std::string& uuid) { return our.uuids.contains(uuid); }))
          known.push_back(&our);
        if (same_code(our.code, theirs.code)) same = &our;
      }
      const bool told = std::any_of(same_patients_.begin(), same_patients_.end(),
                                    [&](const auto& code) { return same_code(code, theirs.code); });
      if (told) used.insert(lower(theirs.code));
      if (known.size() > 1 || (!known.empty() && known.front() != same)) {
        report_.conflicts.push_back("patient " + theirs.code + " is " + known.front()->code +
                                    " here: their codes must agree");
      } else if (same != nullptr && known.empty() && !told) {
        report_.conflicts.push_back("the code " + theirs.code +
                                    " was given in both files separately: only if it is the same "
                                    "person, say --same-patient " +
                                    theirs.code);
      } else if (same != nullptr) {
        join(*same, theirs);
        number("patients", theirs.id, same->id, false);
      } else if (was_erased(theirs.code)) {
        report_.conflicts.push_back("patient " + theirs.code +
                                    " was erased here on request and must not come back");
      } else {
        number("patients", theirs.id, ++next, true);
        add_patient(theirs, next);
      }
    }
    for (const std::string& code : same_patients_)
      if (!used.contains(lower(code)))
        throw Refusal{{Error::Code::bad_input, "patient " + code + " is not in both files",
                       "give a code that both have", "", 0, "--same-patient"}};
  }

  bool was_erased(const std::string& code) {
    int stones = 0;
    sql_ << "SELECT count(*) FROM main.tombstones WHERE code = :code COLLATE NOCASE",
        soci::use(code), soci::into(stones);
    return stones > 0;
  }

  static std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  }

  /// The same person under two UUIDs: whichever file is taken into the other, the smaller one is
  /// theirs and the other is known.
  void join(Patient& ours, const Patient& theirs) {
    ours.uuids.insert(theirs.uuids.begin(), theirs.uuids.end());
    ours.created_utc = std::min(ours.created_utc, theirs.created_utc);
    ours.code = std::min(ours.code, theirs.code);
    sql_ << "DELETE FROM main.patient_aliases WHERE patient_id = :id", soci::use(ours.id);
    sql_ << "UPDATE main.patients SET uuid = :uuid, created_utc = :created, code = :code "
            "WHERE id = :id",
        soci::use(*ours.uuids.begin()), soci::use(ours.created_utc), soci::use(ours.code),
        soci::use(ours.id);
    add_aliases(ours, ours.id);
  }

  void add_patient(const Patient& theirs, RowId id) {
    sql_ << "INSERT INTO main.patients (id, code, created_utc, uuid) "
            "VALUES (:id, :code, :created, :uuid)",
        soci::use(id), soci::use(theirs.code), soci::use(theirs.created_utc),
        soci::use(*theirs.uuids.begin());
    add_aliases(theirs, id);
    ++report_.patients_added;
  }

  void add_aliases(const Patient& of, RowId id) {
    for (auto uuid = std::next(of.uuids.begin()); uuid != of.uuids.end(); ++uuid)
      sql_ << "INSERT INTO main.patient_aliases (uuid, patient_id) VALUES (:uuid, :id)",
          soci::use(*uuid), soci::use(id);
  }

  void number(const std::string& table, RowId there, RowId own, bool added) {
    const int mark = added ? 1 : 0;
    sql_ << "INSERT INTO temp.numbers VALUES (:name, :there, :here, :added)", soci::use(table),
        soci::use(there), soci::use(own), soci::use(mark);
  }

  /// All of a row but its own number, as text. quote() tells every value from every other.
  static std::string content(const Strings& columns, const Table* translate_by) {
    Strings parts;
    for (const auto& column : columns)
      if (column != "id")
        parts.push_back(
            "quote(" +
            (translate_by != nullptr ? translated(*translate_by, column) : "o." + column) + ")");
    return joined(parts, " || ',' || ");
  }

  /// Equal rows of one file are the first, the second … of them.
  static std::string keyed(const std::string& file, const Table& table, const std::string& id,
                           const std::string& key) {
    return "SELECT id, key, row_number() OVER (PARTITION BY key ORDER BY id) AS nth FROM (SELECT "
           "o." +
           id + " AS id, " + key + " AS key FROM " + file + "." + std::string(table.name) + " o)";
  }

  static std::string id_of(const Table& table) {
    return table.key == "patient_id" ? "patient_id" : "id";
  }

  void number_rows(const Table& table) {
    const std::string name(table.name);
    const auto columns = columns_of(sql_, table.name);
    const std::string column(table.key);
    const std::string their_key =
        column.empty() ? content(columns, &table) : translated(table, column);
    const std::string our_key = column.empty() ? content(columns, nullptr) : "o." + column;
    const std::string id = id_of(table);
    sql_ << "CREATE TEMP TABLE theirs AS " + keyed("other", table, id, their_key);
    sql_ << "CREATE TEMP TABLE ours AS " + keyed("main", table, id, our_key);
    sql_ << "CREATE INDEX temp.ours_by_key ON ours (key, nth)";
    sql_ << "INSERT INTO temp.numbers SELECT '" + name +
                "', t.id, u.id, 0 FROM temp.theirs t JOIN temp.ours u ON u.key = t.key "
                "AND u.nth = t.nth";
    // A profile has the number of its patient; all else the next free one, in the order there.
    const std::string next = id == "patient_id" ? here("patients", "t.id")
                                                : "(SELECT coalesce(max(id), 0) FROM main." + name +
                                                      ") + row_number() OVER "
                                                      "(ORDER BY t.id)";
    sql_ << "INSERT INTO temp.numbers SELECT '" + name + "', t.id, " + next +
                ", 1 FROM temp.theirs t WHERE NOT EXISTS (SELECT 1 FROM temp.numbers n "
                "WHERE n.name = '" +
                name + "' AND n.there = t.id)";
    sql_ << "DROP TABLE temp.theirs";
    sql_ << "DROP TABLE temp.ours";
  }

  /// Rows that are the same by their key must have the same content.
  void find_conflicts(const Table& table) {
    if (table.key.empty()) return;
    const auto columns = columns_of(sql_, table.name);
    const std::string id = id_of(table);
    const std::string name(table.name);
    Strings same;
    for (const auto& column : columns)
      if (column != "id") {
        const std::string what = "m." + column + " IS " + translated(table, column);
        std::string other;
        const std::string query = "SELECT " + place(table) + " FROM temp.numbers n JOIN other." +
                                  name + " o ON o." + id + " = n.there JOIN main." + name +
                                  " m ON m." + id + " = n.here WHERE n.name = '" + name +
                                  "' AND NOT n.added AND NOT (" + what + ")";
        soci::statement select = (sql_.prepare << query, soci::into(other));
        select.execute();
        while (select.fetch())
          report_.conflicts.push_back(other + " is in both files with different content (" +
                                      column + ")");
      }
  }

  /// What a person calls row m.
  static std::string place(const Table& table) {
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

  void report_each(const std::string& query) {
    std::string what;
    soci::statement select = (sql_.prepare << query, soci::into(what));
    select.execute();
    while (select.fetch()) report_.conflicts.push_back(what);
  }

  /// Added rows that cannot stand beside those that are here.
  void find_collisions() {
    const std::string added = " JOIN temp.numbers n ON n.there = o.id AND n.added AND n.name = ";
    const std::string code = "(SELECT code FROM main.patients WHERE id = m.patient_id)";
    const std::string same_patient = "m.patient_id = " + here("patients", "o.patient_id");
    report_each(
        "SELECT 'the session of ' || (SELECT code FROM main.patients WHERE id = "
        "s.patient_id) || ' that began ' || s.started_utc || ' has another trial ' || "
        "o.number FROM other.trials o" +
        added + "'trials' JOIN main.trials m ON m.number = o.number AND m.session_id = " +
        here("sessions", "o.session_id") + " JOIN main.sessions s ON s.id = m.session_id");
    report_each("SELECT 'primary measure ' || m.measure || ' of ' || " + code +
                " || ' was chosen in both files' FROM other.primary_measures o" + added +
                "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
                " AND m.task_name = o.task_name AND m.hand = o.hand AND m.measure = o.measure AND "
                "m.channel = o.channel");
    report_each("SELECT " + code + " || ' would have more than " +
                std::to_string(kMostPrimaryMeasures) +
                " primary measures' FROM other.primary_measures o" + added +
                "'primary_measures' JOIN main.primary_measures m ON " + same_patient +
                " GROUP BY m.patient_id HAVING count(DISTINCT o.id) + count(DISTINCT m.id) > " +
                std::to_string(kMostPrimaryMeasures));
    report_each("SELECT 'stable times of ' || " + code +
                " || ' overlap on ' || max(o.from_date, m.from_date) FROM other.stable_periods o" +
                added + "'stable_periods' JOIN main.stable_periods m ON " + same_patient +
                " AND m.from_date <= o.until_date AND m.until_date >= o.from_date");
    // Measures are made once, with their trial.
    report_each(
        "SELECT DISTINCT 'trial ' || t.number || ' of the session of ' || (SELECT p.code || "
        "' that began ' || s.started_utc FROM main.sessions s JOIN main.patients p ON p.id = "
        "s.patient_id WHERE s.id = t.session_id) || ' is in both files with different "
        "measures' FROM temp.numbers x JOIN main.trials t ON t.id = x.here "
        "WHERE x.name = 'trials' AND NOT x.added AND (EXISTS (SELECT 1 FROM other.measures o" +
        added +
        "'measures' WHERE o.trial_id = x.there) OR "
        "(SELECT count(*) FROM main.measures WHERE trial_id = x.here) <> "
        "(SELECT count(*) FROM other.measures WHERE trial_id = x.there))");
  }

  static std::pair<std::string, std::string> names_and_values(const Table& table,
                                                              const Strings& columns) {
    Strings values;
    for (const auto& column : columns)
      values.push_back(column == "id" ? "n.here" : translated(table, column));
    return {joined(columns, ", "), joined(values, ", ")};
  }

  void copy_rows(const Table& table) {
    const std::string name(table.name);
    const auto [names, values] = names_and_values(table, columns_of(sql_, table.name));
    sql_ << "INSERT INTO main." + name + " (" + names + ") SELECT " + values + " FROM other." +
                name + " o JOIN temp.numbers n ON n.name = '" + name + "' AND n.there = o." +
                id_of(table) + " AND n.added ORDER BY o." + id_of(table);
  }

  int count(const std::string& which) {
    int number = 0;
    sql_ << "SELECT count(*) FROM temp.numbers WHERE " + which, soci::into(number);
    return number;
  }

  soci::session& sql_;
  std::span<const std::string> same_patients_;
  MergeReport report_;
};

/// The file is of this program's format, and nobody records into it.
Result<void> check_file(const std::string& path, SessionStore::Open how) {
  {
    // Marks trials that a program left running when it ended.
    const auto store = how == SessionStore::Open::read_only ? SessionStore::open_to_read(path)
                                                            : SessionStore::open(path, how);
    if (!store) return store.error();
  }
  auto database = Database::open(path, SessionStore::Open::read_only);
  if (!database) return database.error();
  if (database->format() != kDatabaseFormat)
    return Error{Error::Code::bad_input,
                 "has format " + std::to_string(database->format()) + " instead of " +
                     std::to_string(kDatabaseFormat),
                 "run isograsp db migrate on it, or on a copy of it",
                 path,
                 0,
                 ""};
  int running = 0;
  const auto read = database->guard("reading", [&] {
    database->sql() << "SELECT count(*) FROM trials WHERE status = 'running'", soci::into(running);
  });
  if (!read) return read.error();
  if (running > 0)
    return Error{Error::Code::failed,
                 "a trial is being recorded into it",
                 "end that session, then merge",
                 path,
                 0,
                 ""};
  return {};
}

}  // namespace

Result<MergeReport> merge_databases(const std::string& into, const std::string& from,
                                    std::span<const std::string> same_patients,
                                    SessionStore::Open into_how) {
  using Open = SessionStore::Open;
  std::error_code ignored;
  if (std::filesystem::equivalent(into, from, ignored))
    return Error{Error::Code::bad_input, "is the same file", "name two files", from, 0, "--from"};
  if (const auto good = check_file(into, into_how); !good) return good.error();
  if (const auto good = check_file(from, Open::read_only); !good) return good.error();
  auto database = Database::open(into, into_how);
  if (!database) return database.error();
  if (is_protected_database(into) || is_protected_database(from))
    return Error{Error::Code::bad_input,
                 "a protected database cannot be merged with another one: their keys differ",
                 "export from one, or work with both",
                 is_protected_database(into) ? into : from,
                 0,
                 ""};
  std::shared_ptr<LoginState> state;
  const auto attached = database->guard("opening the other file", [&] {
    state = login_state_of(*database);
    database->sql() << "ATTACH DATABASE :other AS other", soci::use(from);
  });
  if (!attached) return attached.error();
  MergeReport report;
  AuditEntry entry = entry_of("merge", std::filesystem::path(from).filename());
  const auto merge = [&] {
    return database->transact("merging", [&] {
      report = Merging(database->sql(), same_patients).run();
      if (!report.conflicts.empty())
        throw Refusal{{Error::Code::failed, "the files do not agree", "", from, 0, ""}};
    });
  };
  const auto done = database->is_scratch() ? merge() : audited(*database, *state, entry, merge);
  if (!done && report.conflicts.empty()) return done.error();
  return report;
}

}  // namespace isograsp
