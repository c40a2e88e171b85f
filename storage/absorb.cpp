// SPDX-License-Identifier: GPL-3.0-or-later
// One file taken into another: every row keeps its content and gets the next free number.
#include <array>
#include <string_view>

#include <soci/soci.h>

#include "storage/sqlite_store.hpp"

namespace isograsp {

namespace {

/// A table and which of its columns number rows of which table.
struct Numbered {
  std::string_view column;
  std::string_view of;
};
struct Table {
  std::string_view name;
  std::array<Numbered, 3> numbers;  ///< unused ones are empty
};
/// In an order in which nothing refers to what is not there yet.
constexpr std::array<Table, 14> kTables{{
    {"patients", {{{"id", "patients"}, {}, {}}}},
    {"patient_profiles", {{{"patient_id", "patients"}, {}, {}}}},
    {"treatment_marks", {{{"id", "treatment_marks"}, {"patient_id", "patients"}, {}}}},
    {"clinical_scores", {{{"id", "clinical_scores"}, {"patient_id", "patients"}, {}}}},
    {"sessions", {{{"id", "sessions"}, {"patient_id", "patients"}, {"resumes_id", "sessions"}}}},
    {"session_answers", {{{"id", "session_answers"}, {"session_id", "sessions"}, {}}}},
    {"instrument_zeros", {{{"id", "instrument_zeros"}, {"session_id", "sessions"}, {}}}},
    {"trials", {{{"id", "trials"}, {"session_id", "sessions"}, {"zero_id", "instrument_zeros"}}}},
    {"signal_groups", {{{"trial_id", "trials"}, {}, {}}}},
    {"signal_blocks", {{{"trial_id", "trials"}, {}, {}}}},
    {"measures", {{{"id", "measures"}, {"trial_id", "trials"}, {}}}},
    {"events", {{{"id", "events"}, {"session_id", "sessions"}, {"trial_id", "trials"}}}},
    {"resting_forces",
     {{{"id", "resting_forces"}, {"session_id", "sessions"}, {"trial_id", "trials"}}}},
    {"ratings", {{{"id", "ratings"}, {"session_id", "sessions"}, {"trial_id", "trials"}}}},
}};

std::string last_number(std::string_view table) {
  return "(SELECT last FROM temp.lasts WHERE name = '" + std::string(table) + "')";
}

/// "a, b, id + (…)": the columns of a table as they are to be inserted.
struct Columns {
  std::string names;
  std::string values;
};
Columns columns_of(soci::session& sql, const Table& table) {
  Columns columns;
  std::string name;
  const std::string query =
      "SELECT name FROM pragma_table_info('" + std::string(table.name) + "') ORDER BY cid";
  soci::statement select = (sql.prepare << query, soci::into(name));
  select.execute();
  while (select.fetch()) {
    const char* separator = columns.names.empty() ? "" : ", ";
    columns.names += separator + name;
    columns.values += separator + name;
    for (const Numbered& number : table.numbers)
      if (number.column == name) columns.values += " + " + last_number(number.of);
  }
  return columns;
}

}  // namespace

Result<void> SqliteStore::absorb(const std::string& other) {
  const auto attached = database_.guard("opening the other file", [&] {
    database_.sql() << "ATTACH DATABASE :other AS other", soci::use(other);
  });
  if (!attached) return attached.error();
  const auto done = database_.transact("absorbing another file", [&] {
    soci::session& sql = database_.sql();
    int format = 0;
    sql << "PRAGMA other.user_version", soci::into(format);
    if (format != kDatabaseFormat)
      throw Refusal{refuse(other + " has another format", "migrate it first")};
    std::string taken;
    sql << "SELECT p.code FROM other.patients p JOIN main.patients m ON m.code = p.code LIMIT 1",
        soci::into(taken);
    if (sql.got_data())
      throw Refusal{refuse("patient " + taken + " exists in both files",
                           "only files of different patients can be put together")};
    sql << "CREATE TEMP TABLE lasts (name TEXT PRIMARY KEY, last INTEGER NOT NULL)";
    for (const Table& table : kTables) {
      const std::string name(table.name);
      if (table.numbers[0].column == "id")
        sql << "INSERT INTO temp.lasts SELECT '" + name + "', coalesce(max(id), 0) FROM main." +
                   name;
    }
    for (const Table& table : kTables) {
      const Columns columns = columns_of(sql, table);
      const std::string name(table.name);
      sql << "INSERT INTO main." + name + " (" + columns.names + ") SELECT " + columns.values +
                 " FROM other." + name + " ORDER BY rowid";
    }
    sql << "DROP TABLE temp.lasts";
  });
  const auto detached = database_.guard("closing the other file",
                                        [&] { database_.sql() << "DETACH DATABASE other"; });
  return done ? detached : done;
}

}  // namespace isograsp
