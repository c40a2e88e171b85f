// SPDX-License-Identifier: GPL-3.0-or-later
// Formats 1 to 7 were made for a platform of three fingers, so this file names them. It says how
// each format came of the one before, and how format 7 becomes the tables of today: for migration
// and for reading an old file as it is, by the same statements. Format 9 brought the seals of rows,
// format 10 no table: it binds sealed texts to their rows (storage/access/sealed_text.hpp).
#include "storage/file/old_formats.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "storage/file/open_mode.hpp"
#include "storage/file/schema.hpp"
#include "storage/file/schema_access.hpp"

namespace isograsp::storage::schema {

namespace {

constexpr int kLastOfFingers = 7;

const std::array<const char*, 16> kToFormat2{
    "ALTER TABLE sessions ADD COLUMN device_serials TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE sessions ADD COLUMN operator_name TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE sessions ADD COLUMN realtime TEXT NOT NULL DEFAULT ''",

    "ALTER TABLE instrument_zeros ADD COLUMN recorded_utc TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE instrument_zeros ADD COLUMN operator_name TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE instrument_zeros ADD COLUMN change_N REAL CHECK (change_N >= 0)",
    "ALTER TABLE instrument_zeros ADD COLUMN change_confirmed INTEGER NOT NULL DEFAULT 0 "
    "CHECK (change_confirmed IN (0, 1))",
    "ALTER TABLE instrument_zeros ADD COLUMN drift_N REAL CHECK (drift_N >= 0)",

    "ALTER TABLE trials ADD COLUMN zero_drift_N REAL CHECK (zero_drift_N >= 0)",
    "ALTER TABLE trials ADD COLUMN zero_drifted INTEGER NOT NULL DEFAULT 0 "
    "CHECK (zero_drifted IN (0, 1))",
    "ALTER TABLE trials ADD COLUMN thumb_threshold_N REAL CHECK (thumb_threshold_N >= 0)",
    "ALTER TABLE trials ADD COLUMN index_threshold_N REAL CHECK (index_threshold_N >= 0)",
    "ALTER TABLE trials ADD COLUMN middle_threshold_N REAL CHECK (middle_threshold_N >= 0)",
    "ALTER TABLE trials ADD COLUMN timing_json TEXT NOT NULL DEFAULT ''",

    R"(CREATE TABLE resting_forces (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  trial_id INTEGER NOT NULL UNIQUE,
  session_time_s REAL NOT NULL,
  recorded_utc TEXT NOT NULL,
  operator_name TEXT NOT NULL,
  duration_s REAL NOT NULL CHECK (duration_s > 0),
  since_strapping_s REAL CHECK (since_strapping_s >= 0),
  sample_count INTEGER NOT NULL CHECK (sample_count >= 2),
  mean_N_Nm BLOB NOT NULL CHECK (length(mean_N_Nm) = 144),
  sd_N_Nm BLOB NOT NULL CHECK (length(sd_N_Nm) = 144),
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id)
) STRICT)",

    "CREATE INDEX resting_forces_of_session ON resting_forces (session_id)",
};

const std::array<const char*, 10> kToFormat3{
    "ALTER TABLE sessions ADD COLUMN resumes_id INTEGER REFERENCES sessions (id)",
    "ALTER TABLE sessions ADD COLUMN allowed TEXT NOT NULL DEFAULT '' "
    "CHECK (allowed IN ('', 'maximum', 'comfortable', 'none'))",
    "ALTER TABLE sessions ADD COLUMN ceiling_N REAL CHECK (ceiling_N > 0)",

    "ALTER TABLE trials ADD COLUMN seed TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE trials ADD COLUMN step INTEGER CHECK (step >= 0)",
    "ALTER TABLE trials ADD COLUMN step_task INTEGER CHECK ((step_task IS NULL) = (step IS NULL))",
    "ALTER TABLE trials ADD COLUMN helped INTEGER NOT NULL DEFAULT 0 CHECK (helped IN (0, 1))",

    R"(CREATE TABLE ratings (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  trial_id INTEGER,
  session_time_s REAL NOT NULL,
  recorded_utc TEXT NOT NULL,
  effort INTEGER NOT NULL CHECK (effort BETWEEN 0 AND 10),
  pain INTEGER NOT NULL CHECK (pain BETWEEN 0 AND 10),
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id)
) STRICT)",

    "CREATE INDEX ratings_of_session ON ratings (session_id)",
    "CREATE INDEX sessions_that_resume ON sessions (resumes_id) WHERE resumes_id IS NOT NULL",
};

const std::array<const char*, 11> kToFormat4{
    R"(CREATE TABLE patient_profiles (
  patient_id INTEGER PRIMARY KEY REFERENCES patients (id),
  affected TEXT NOT NULL CHECK (affected IN ('', 'right', 'left', 'both', 'none')),
  dominant TEXT NOT NULL CHECK (dominant IN ('', 'right', 'left')),
  onset_date TEXT NOT NULL CHECK (onset_date = '' OR date(onset_date, '+0 days') IS onset_date),
  notes TEXT NOT NULL,
  goals TEXT NOT NULL
) STRICT)",

    R"(CREATE TABLE treatment_marks (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  on_date TEXT NOT NULL CHECK (date(on_date, '+0 days') IS on_date),
  kind TEXT NOT NULL CHECK (kind <> ''),
  text TEXT NOT NULL
) STRICT)",

    "CREATE INDEX treatment_marks_of_patient ON treatment_marks (patient_id)",

    R"(CREATE TABLE clinical_scores (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  on_date TEXT NOT NULL CHECK (date(on_date, '+0 days') IS on_date),
  scale TEXT NOT NULL CHECK (scale <> ''),
  value REAL NOT NULL,
  text TEXT NOT NULL
) STRICT)",

    "CREATE INDEX clinical_scores_of_patient ON clinical_scores (patient_id)",

    R"(CREATE TABLE session_answers (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  topic TEXT NOT NULL CHECK (topic <> ''),
  item TEXT NOT NULL CHECK (item <> ''),
  value TEXT NOT NULL
) STRICT)",

    "CREATE INDEX answers_of_session ON session_answers (session_id)",
    "CREATE INDEX sessions_by_start ON sessions (started_utc, id)",

    "ALTER TABLE trials ADD COLUMN display_age_s REAL CHECK (display_age_s >= 0)",
    "ALTER TABLE trials ADD COLUMN visual_gain_deg_per_N REAL CHECK (visual_gain_deg_per_N > 0)",
    "ALTER TABLE trials ADD COLUMN viewing_distance_m REAL CHECK (viewing_distance_m > 0)",
};

const std::array<const char*, 3> kToFormat5{
    R"(CREATE TABLE primary_measures (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  task_name TEXT NOT NULL CHECK (task_name <> ''),
  hand TEXT NOT NULL CHECK (hand IN ('right', 'left')),
  measure TEXT NOT NULL CHECK (measure <> ''),
  channel TEXT NOT NULL,
  chosen_utc TEXT NOT NULL,
  chosen_by TEXT NOT NULL CHECK (chosen_by <> ''),
  UNIQUE (patient_id, task_name, hand, measure, channel)
) STRICT)",

    R"(CREATE TABLE stable_periods (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  from_date TEXT NOT NULL CHECK (date(from_date, '+0 days') IS from_date),
  until_date TEXT NOT NULL CHECK (date(until_date, '+0 days') IS until_date),
  judged_utc TEXT NOT NULL,
  judged_by TEXT NOT NULL CHECK (judged_by <> ''),
  text TEXT NOT NULL,
  CHECK (from_date <= until_date)
) STRICT)",

    "CREATE INDEX stable_periods_of_patient ON stable_periods (patient_id)",
};

const std::array<const char*, 10> kToFormat6{
    "ALTER TABLE patients ADD COLUMN uuid TEXT CHECK (length(uuid) = 36)",
    "ALTER TABLE sessions ADD COLUMN uuid TEXT CHECK (length(uuid) = 36)",
    "ALTER TABLE trials ADD COLUMN uuid TEXT CHECK (length(uuid) = 36)",
    "CREATE UNIQUE INDEX patients_by_uuid ON patients (uuid)",
    "CREATE UNIQUE INDEX sessions_by_uuid ON sessions (uuid)",
    "CREATE UNIQUE INDEX trials_by_uuid ON trials (uuid)",

    R"(CREATE TABLE patient_aliases (
  uuid TEXT PRIMARY KEY CHECK (length(uuid) = 36),
  patient_id INTEGER NOT NULL REFERENCES patients (id)
) STRICT)",

    "ALTER TABLE sessions ADD COLUMN calibration TEXT NOT NULL DEFAULT ''",
    "ALTER TABLE trials ADD COLUMN signals_blake2b BLOB CHECK (length(signals_blake2b) = 32)",

    R"(CREATE TABLE signal_packs (
  trial_id INTEGER NOT NULL,
  position INTEGER NOT NULL,
  part INTEGER NOT NULL CHECK (part >= 0),
  row_count INTEGER NOT NULL CHECK (row_count > 0),
  values_blake2b BLOB NOT NULL CHECK (length(values_blake2b) = 32),
  float64_shuffled_zstd BLOB NOT NULL,
  PRIMARY KEY (trial_id, position, part),
  FOREIGN KEY (trial_id, position) REFERENCES signal_groups (trial_id, position)
) STRICT)",
};

/// Access and privacy; and what healthy people are matched by.
const std::array<const char*, 2> kProfileInFormat7{
    "ALTER TABLE patient_profiles ADD COLUMN sex TEXT NOT NULL DEFAULT '' "
    "CHECK (sex IN ('', 'female', 'male', 'other'))",
    "ALTER TABLE patient_profiles ADD COLUMN birth_year INTEGER "
    "CHECK (birth_year BETWEEN 1900 AND 2099)",
};

/// A column of format 7 that came after its table.
struct LateColumn {
  std::string_view table;
  const char* column;
  int since;            ///< first format that has it
  const char* instead;  ///< SQL: what stands for it in older files
};
constexpr std::array kLateColumns{
    LateColumn{"patients", "uuid", 6, "NULL"},
    LateColumn{"patient_profiles", "sex", 7, "''"},
    LateColumn{"patient_profiles", "birth_year", 7, "NULL"},
    LateColumn{"sessions", "device_serials", 2, "''"},
    LateColumn{"sessions", "operator_name", 2, "''"},
    LateColumn{"sessions", "realtime", 2, "''"},
    LateColumn{"sessions", "resumes_id", 3, "NULL"},
    LateColumn{"sessions", "allowed", 3, "''"},
    LateColumn{"sessions", "ceiling_N", 3, "NULL"},
    LateColumn{"sessions", "uuid", 6, "NULL"},
    LateColumn{"sessions", "calibration", 6, "''"},
    LateColumn{"instrument_zeros", "recorded_utc", 2, "''"},
    LateColumn{"instrument_zeros", "operator_name", 2, "''"},
    LateColumn{"instrument_zeros", "change_N", 2, "NULL"},
    LateColumn{"instrument_zeros", "change_confirmed", 2, "0"},
    LateColumn{"instrument_zeros", "drift_N", 2, "NULL"},
    LateColumn{"trials", "zero_drifted", 2, "0"},
    LateColumn{"trials", "thumb_threshold_N", 2, "NULL"},
    LateColumn{"trials", "index_threshold_N", 2, "NULL"},
    LateColumn{"trials", "middle_threshold_N", 2, "NULL"},
    LateColumn{"trials", "timing_json", 2, "''"},
    LateColumn{"trials", "seed", 3, "''"},
    LateColumn{"trials", "step", 3, "NULL"},
    LateColumn{"trials", "step_task", 3, "NULL"},
    LateColumn{"trials", "helped", 3, "0"},
    LateColumn{"trials", "display_age_s", 4, "NULL"},
    LateColumn{"trials", "visual_gain_deg_per_N", 4, "NULL"},
    LateColumn{"trials", "viewing_distance_m", 4, "NULL"},
    LateColumn{"trials", "uuid", 6, "NULL"},
    LateColumn{"trials", "signals_blake2b", 6, "NULL"},
};

/// Tables of format 7 that have become others.
struct OldTable {
  std::string_view name;
  int since;  ///< first format that has it
};
constexpr std::array kOldTables{
    OldTable{"patients", 1},       OldTable{"patient_profiles", 4}, OldTable{"primary_measures", 5},
    OldTable{"sessions", 1},       OldTable{"trials", 1},           OldTable{"instrument_zeros", 1},
    OldTable{"resting_forces", 2},
};
constexpr const char* kNoRestingForces =
    "SELECT 0 AS id, 0 AS session_id, 0 AS trial_id, 0.0 AS session_time_s, '' AS recorded_utc, "
    "'' AS operator_name, 0.0 AS duration_s, NULL AS since_strapping_s, 0 AS sample_count, "
    "x'' AS mean_N_Nm, x'' AS sd_N_Nm WHERE 0";

/// The components of the fingers' wrenches, in the order of the old columns …_N_Nm; one a line.
constexpr const char* kWrenchColumns = R"('thumb_fx_N
thumb_fy_N
thumb_fz_N
thumb_tx_Nm
thumb_ty_Nm
thumb_tz_Nm
index_fx_N
index_fy_N
index_fz_N
index_tx_Nm
index_ty_Nm
index_tz_Nm
middle_fx_N
middle_fy_N
middle_fz_N
middle_tx_Nm
middle_ty_Nm
middle_tz_Nm')";

/// A table of today, of the tables of format 7 (old_…): all its columns, in their order. $columns
/// are kWrenchColumns.
struct Successor {
  const char* name;
  int since;  ///< files of older formats have nothing to fill it with
  const char* select;
};
constexpr std::array kSuccessors{
    // Format 9 makes this table anew, with a random number.
    Successor{"patients", 1,
              "SELECT id, code, created_utc, uuid, zeroblob(16) AS salt FROM old_patients"},
    Successor{"patient_profiles", 4,
              "SELECT patient_id, affected, dominant, onset_date, notes, goals, sex, birth_year "
              "FROM old_patient_profiles"},
    Successor{"primary_measures", 5,
              "SELECT id, patient_id, task_name, hand, measure, channel, chosen_utc, chosen_by "
              "FROM old_primary_measures"},
    Successor{"sessions", 1,
              "SELECT id, patient_id, uuid, resumes_id, started_utc, ended_utc, hand, device_uri, "
              "device_description, calibration, simulated, recorded, provenance, protocol_name, "
              "protocol_text, rate_Hz, device_delay_s, software_version, cpu_features, seed, "
              "operator_name, realtime, allowed FROM old_sessions"},
    // One a line: thumb, index, middle; nothing where no sensor told its own.
    Successor{"session_sensors", 1, R"(
WITH told AS (SELECT id, device_serials AS list, instr(device_serials, char(10)) AS first
              FROM old_sessions WHERE device_serials <> ''),
     rest AS (SELECT id, substr(list, first + 1) AS list, substr(list, 1, first - 1) AS thumb
              FROM told)
SELECT id AS session_id, 0 AS position, 'thumb' AS name, thumb AS serial_number FROM rest
UNION ALL SELECT id, 1, 'index', substr(list, 1, instr(list, char(10)) - 1) FROM rest
UNION ALL SELECT id, 2, 'middle', substr(list, instr(list, char(10)) + 1) FROM rest)"},
    Successor{"session_references", 1,
              "SELECT id AS session_id, 'ceiling_N' AS name, ceiling_N AS value "
              "FROM old_sessions WHERE ceiling_N IS NOT NULL"},
    Successor{"trials", 1,
              "SELECT id, session_id, uuid, number, step, step_task, task_name, task_version, "
              "task_text, scene_text, seed, practice, helped, session_time_s, status, "
              "sample_count, dropped_count, worst_lateness_s, worst_compute_s, display_age_s, "
              "viewing_distance_m, health_json, timing_json, signals_blake2b FROM old_trials"},
    // 0 stood for what was not measured.
    Successor{"trial_references", 1, R"(
SELECT id AS trial_id, 'maximum_force_N' AS name, maximum_force_N AS value
  FROM old_trials WHERE maximum_force_N <> 0
UNION ALL SELECT id, 'resting_force_N', resting_force_N
  FROM old_trials WHERE resting_force_N <> 0
UNION ALL SELECT id, 'thumb_threshold_N', thumb_threshold_N
  FROM old_trials WHERE thumb_threshold_N IS NOT NULL
UNION ALL SELECT id, 'index_threshold_N', index_threshold_N
  FROM old_trials WHERE index_threshold_N IS NOT NULL
UNION ALL SELECT id, 'middle_threshold_N', middle_threshold_N
  FROM old_trials WHERE middle_threshold_N IS NOT NULL
UNION ALL SELECT id, 'visual_gain_deg_per_N', visual_gain_deg_per_N
  FROM old_trials WHERE visual_gain_deg_per_N IS NOT NULL)"},
    // Resting forces get numbers behind those of all zeros. That a zero had drifted stood with the
    // trials since the one before it.
    Successor{"preparations", 1, R"(
SELECT z.id, z.session_id, 'instrument_zero' AS kind, NULL AS trial_id, z.session_time_s,
  z.recorded_utc, z.operator_name, z.change_confirmed,
  EXISTS (SELECT 1 FROM old_trials t WHERE t.zero_drifted = 1 AND t.session_id = z.session_id
          AND t.zero_id = (SELECT max(y.id) FROM old_instrument_zeros y
                           WHERE y.session_id = z.session_id AND y.id < z.id)) AS drifted,
  NULL AS sample_count, $columns AS column_names,
  z.mean_N_Nm AS mean_float64, z.sd_N_Nm AS sd_float64 FROM old_instrument_zeros z
UNION ALL SELECT r.id + (SELECT coalesce(max(id), 0) FROM old_instrument_zeros), r.session_id,
  'resting_force', r.trial_id, r.session_time_s, r.recorded_utc, r.operator_name, 0, 0,
  r.sample_count, $columns, r.mean_N_Nm, r.sd_N_Nm
  FROM old_resting_forces r)"},
    Successor{"preparation_references", 1, R"(
SELECT id AS preparation_id, 'change_N' AS name, change_N AS value
  FROM old_instrument_zeros WHERE change_N IS NOT NULL
UNION ALL SELECT id, 'drift_N', drift_N FROM old_instrument_zeros WHERE drift_N IS NOT NULL
UNION ALL SELECT id + (SELECT coalesce(max(id), 0) FROM old_instrument_zeros), 'duration_s',
  duration_s FROM old_resting_forces
UNION ALL SELECT id + (SELECT coalesce(max(id), 0) FROM old_instrument_zeros),
  'since_strapping_s', since_strapping_s FROM old_resting_forces
  WHERE since_strapping_s IS NOT NULL)"},
    Successor{"trial_preparations", 1,
              "SELECT id AS trial_id, zero_id AS preparation_id, session_id FROM old_trials "
              "WHERE zero_id IS NOT NULL"},
};

std::string old(std::string_view table) {
  return "old_" + std::string(table);
}

std::string select_of(const Successor& table) {
  constexpr std::string_view kMark = "$columns";
  std::string select = table.select;
  for (auto at = select.find(kMark); at != std::string::npos; at = select.find(kMark))
    select.replace(at, kMark.size(), kWrenchColumns);
  return select;
}

const Table& table_of(std::string_view name) {
  const auto all = tables();
  return *std::find_if(all.begin(), all.end(), [&](const Table& one) { return one.name == name; });
}

std::vector<std::string> to_format_8() {
  std::vector<std::string> all;
  for (const OldTable& table : kOldTables)
    all.push_back("ALTER TABLE " + std::string(table.name) + " RENAME TO " + old(table.name));
  for (const Successor& table : kSuccessors) {
    all.emplace_back(table_of(table.name).create);
    all.push_back("INSERT INTO " + std::string(table.name) + " SELECT * FROM (" + select_of(table) +
                  ")");
  }
  for (const OldTable& table : kOldTables) all.push_back("DROP TABLE " + old(table.name));
  for (const Successor& table : kSuccessors)
    for (const char* index : table_of(table.name).indexes)
      if (index != nullptr) all.emplace_back(index);
  return all;
}

/// Tables that format 9 makes anew. The columns of before stand by name: a file of an older format
/// has come here by steps that made the tables of today.
std::vector<std::string> to_format_9() {
  struct Anew {
    std::string table;
    std::string columns;  ///< that format 8 had
    std::string more;     ///< ", column" …
    std::string value;    ///< … and what it gets
  };
  const std::array<Anew, 3> tables{
      {{"patients", "id, code, created_utc, uuid", ", salt", ", randomblob(16)"},
       {"patient_aliases", "uuid, patient_id", "", ""},
       {"audit_log", "id, at_utc, actor, role, act, object, result, detail, hash", "", ""}}};
  std::vector<std::string> all;
  for (const Anew& one : tables) {
    all.push_back("ALTER TABLE " + one.table + " RENAME TO " + old(one.table));
    // With its triggers; indexes keep their names until the old table goes.
    for (const std::string& statement : statements())
      if (statement.starts_with("CREATE TABLE " + one.table + " ")) all.push_back(statement);
    all.push_back("INSERT INTO " + one.table + " (" + one.columns + one.more + ") SELECT " +
                  one.columns + one.value + " FROM " + old(one.table) + " ORDER BY rowid");
    all.push_back("DROP TABLE " + old(one.table));
    for (const std::string& statement : statements())
      if (!statement.starts_with("CREATE TABLE ") &&
          statement.find(" ON " + one.table + " ") != std::string::npos)
        all.push_back(statement);
  }
  all.insert(all.end(), seal_statements().begin(), seal_statements().end());
  return all;
}

std::vector<std::string> to_format_7() {
  std::vector<std::string> all(access_statements().begin(), access_statements().end());
  all.insert(all.end(), kProfileInFormat7.begin(), kProfileInFormat7.end());
  return all;
}

/// All of an old table, with what stands for columns that it does not have yet.
std::string view_of(const OldTable& table, int format) {
  const std::string head = "CREATE TEMP VIEW " + old(table.name) + " AS ";
  if (format < table.since) return head + kNoRestingForces;
  std::string columns = "m.*";
  for (const LateColumn& late : kLateColumns)
    if (late.table == table.name && late.since > format)
      columns += std::string(", ") + late.instead + " AS " + late.column;
  return head + "SELECT " + columns + " FROM main." + std::string(table.name) + " m";
}

}  // namespace

std::vector<std::string> statements_to(int format) {
  const auto all = [](const auto& list) {
    return std::vector<std::string>(list.begin(), list.end());
  };
  switch (format) {
    case 2: return all(kToFormat2);
    case 3: return all(kToFormat3);
    case 4: return all(kToFormat4);
    case 5: return all(kToFormat5);
    case 6: return all(kToFormat6);
    case kLastOfFingers: return to_format_7();
    case kLastOfFingers + 1: return to_format_8();
    case kSealFormat: return to_format_9();
    default: return {};  // 10: the tables of 9; sealed texts are bound anew
  }
}

std::vector<std::string> views_of(int format) {
  std::vector<std::string> all;
  if (format > kLastOfFingers) return all;
  for (const OldTable& table : kOldTables)
    if (table.since <= format || table.name == "resting_forces")
      all.push_back(view_of(table, format));
  for (const Successor& table : kSuccessors)
    if (table.since <= format)
      all.push_back("CREATE TEMP VIEW " + std::string(table.name) + " AS " + select_of(table));
  return all;
}

}  // namespace isograsp::storage::schema
