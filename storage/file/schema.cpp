// SPDX-License-Identifier: GPL-3.0-or-later
// STRICT refuses a value of the wrong kind. `ANY … typeof 'real'` is a float64 that may be
// negative: a REAL column would turn -0.0 into 0.0. `date(…, '+0 days')` reckons the date: 30
// February becomes another day, so it is not what was given.
// `salt`: 16 random bytes that enter the seals of all rows of the person.
// What only some kinds of session know stands by name: numbers in the tables …_references, what was
// measured before trials in `preparations` with the names of its columns, sensors one a row.
#include "storage/file/schema.hpp"

#include <array>

#include "storage/file/schema_access.hpp"

namespace isograsp::storage::schema {

namespace {

const std::array kTables{
    Table{"patients",
          R"(CREATE TABLE patients (
  id INTEGER PRIMARY KEY,
  code TEXT NOT NULL UNIQUE COLLATE NOCASE CHECK (length(code) BETWEEN 2 AND 32),
  created_utc TEXT NOT NULL,
  uuid TEXT CHECK (length(uuid) = 36),
  salt BLOB NOT NULL CHECK (length(salt) = 16)
) STRICT)",
          {"CREATE UNIQUE INDEX patients_by_uuid ON patients (uuid)"}},

    Table{"patient_aliases",
          R"(CREATE TABLE patient_aliases (
  id INTEGER PRIMARY KEY,
  uuid TEXT NOT NULL UNIQUE CHECK (length(uuid) = 36),
  patient_id INTEGER NOT NULL REFERENCES patients (id)
) STRICT)",
          {}},

    Table{"patient_profiles",
          R"(CREATE TABLE patient_profiles (
  patient_id INTEGER PRIMARY KEY REFERENCES patients (id),
  affected TEXT NOT NULL CHECK (affected IN ('', 'right', 'left', 'both', 'none')),
  dominant TEXT NOT NULL CHECK (dominant IN ('', 'right', 'left')),
  onset_date TEXT NOT NULL CHECK (onset_date = '' OR date(onset_date, '+0 days') IS onset_date),
  notes TEXT NOT NULL,
  goals TEXT NOT NULL,
  sex TEXT NOT NULL DEFAULT '' CHECK (sex IN ('', 'female', 'male', 'other')),
  birth_year INTEGER CHECK (birth_year BETWEEN 1900 AND 2099)
) STRICT)",
          {}},

    Table{"treatment_marks",
          R"(CREATE TABLE treatment_marks (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  on_date TEXT NOT NULL CHECK (date(on_date, '+0 days') IS on_date),
  kind TEXT NOT NULL CHECK (kind <> ''),
  text TEXT NOT NULL
) STRICT)",
          {"CREATE INDEX treatment_marks_of_patient ON treatment_marks (patient_id)"}},

    Table{"clinical_scores",
          R"(CREATE TABLE clinical_scores (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  on_date TEXT NOT NULL CHECK (date(on_date, '+0 days') IS on_date),
  scale TEXT NOT NULL CHECK (scale <> ''),
  value REAL NOT NULL,
  text TEXT NOT NULL
) STRICT)",
          {"CREATE INDEX clinical_scores_of_patient ON clinical_scores (patient_id)"}},

    Table{"primary_measures",
          R"(CREATE TABLE primary_measures (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  task_name TEXT NOT NULL CHECK (task_name <> ''),
  hand TEXT NOT NULL CHECK (hand IN ('right', 'left', 'both')),
  measure TEXT NOT NULL CHECK (measure <> ''),
  channel TEXT NOT NULL,
  chosen_utc TEXT NOT NULL,
  chosen_by TEXT NOT NULL CHECK (chosen_by <> ''),
  UNIQUE (patient_id, task_name, hand, measure, channel)
) STRICT)",
          {}},

    Table{"stable_periods",
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
          {"CREATE INDEX stable_periods_of_patient ON stable_periods (patient_id)"}},

    Table{"sessions",
          R"(CREATE TABLE sessions (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  uuid TEXT CHECK (length(uuid) = 36),
  resumes_id INTEGER REFERENCES sessions (id),
  started_utc TEXT NOT NULL,
  ended_utc TEXT NOT NULL DEFAULT '',
  hand TEXT NOT NULL CHECK (hand IN ('right', 'left', 'both')),
  device_uri TEXT NOT NULL,
  device_description TEXT NOT NULL,
  calibration TEXT NOT NULL,
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  recorded INTEGER NOT NULL CHECK (recorded IN (0, 1)),
  provenance TEXT NOT NULL,
  protocol_name TEXT NOT NULL,
  protocol_text TEXT NOT NULL,
  rate_Hz REAL NOT NULL CHECK (rate_Hz > 0),
  device_delay_s REAL NOT NULL CHECK (device_delay_s >= 0),
  software_version TEXT NOT NULL,
  cpu_features TEXT NOT NULL,
  seed TEXT NOT NULL,
  operator_name TEXT NOT NULL,
  realtime TEXT NOT NULL,
  allowed TEXT NOT NULL CHECK (allowed IN ('', 'maximum', 'comfortable', 'none'))
) STRICT)",
          {"CREATE UNIQUE INDEX sessions_by_uuid ON sessions (uuid)",
           "CREATE INDEX sessions_of_patient ON sessions (patient_id)",
           "CREATE INDEX sessions_by_start ON sessions (started_utc, id)",
           "CREATE INDEX sessions_that_resume ON sessions (resumes_id) WHERE resumes_id IS NOT "
           "NULL"}},

    Table{"session_sensors",
          R"(CREATE TABLE session_sensors (
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL CHECK (name <> ''),
  serial_number TEXT NOT NULL,
  PRIMARY KEY (session_id, position)
) STRICT, WITHOUT ROWID)",
          {}},

    Table{"session_references",
          R"(CREATE TABLE session_references (
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  name TEXT NOT NULL CHECK (name <> ''),
  value ANY NOT NULL CHECK (typeof(value) = 'real'),
  PRIMARY KEY (session_id, name)
) STRICT, WITHOUT ROWID)",
          {}},

    Table{"session_answers",
          R"(CREATE TABLE session_answers (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  topic TEXT NOT NULL CHECK (topic <> ''),
  item TEXT NOT NULL CHECK (item <> ''),
  value TEXT NOT NULL
) STRICT)",
          {"CREATE INDEX answers_of_session ON session_answers (session_id)"}},

    Table{"trials",
          R"(CREATE TABLE trials (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  uuid TEXT CHECK (length(uuid) = 36),
  number INTEGER NOT NULL CHECK (number >= 1),
  step INTEGER CHECK (step >= 0),
  step_task INTEGER CHECK ((step_task IS NULL) = (step IS NULL)),
  task_name TEXT NOT NULL,
  task_version INTEGER NOT NULL,
  task_text TEXT NOT NULL,
  scene_text TEXT NOT NULL,
  seed TEXT NOT NULL,
  practice INTEGER NOT NULL CHECK (practice IN (0, 1)),
  helped INTEGER NOT NULL DEFAULT 0 CHECK (helped IN (0, 1)),
  session_time_s REAL NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('running', 'completed', 'aborted', 'interrupted')),
  sample_count INTEGER CHECK (sample_count >= 0),
  dropped_count INTEGER NOT NULL DEFAULT 0 CHECK (dropped_count >= 0),
  worst_lateness_s REAL NOT NULL DEFAULT 0,
  worst_compute_s REAL NOT NULL DEFAULT 0,
  display_age_s REAL CHECK (display_age_s >= 0),
  viewing_distance_m REAL CHECK (viewing_distance_m > 0),
  health_json TEXT NOT NULL DEFAULT '',
  timing_json TEXT NOT NULL DEFAULT '',
  signals_blake2b BLOB CHECK (length(signals_blake2b) = 32),
  UNIQUE (session_id, number),
  UNIQUE (session_id, id),
  CHECK ((status = 'running') = (sample_count IS NULL))
) STRICT)",
          {"CREATE UNIQUE INDEX trials_by_uuid ON trials (uuid)",
           "CREATE INDEX running_trials ON trials (id) WHERE status = 'running'"}},

    Table{"trial_references",
          R"(CREATE TABLE trial_references (
  trial_id INTEGER NOT NULL REFERENCES trials (id),
  name TEXT NOT NULL CHECK (name <> ''),
  value ANY NOT NULL CHECK (typeof(value) = 'real'),
  PRIMARY KEY (trial_id, name)
) STRICT, WITHOUT ROWID)",
          {}},

    Table{"preparations",
          R"(CREATE TABLE preparations (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  kind TEXT NOT NULL CHECK (kind <> ''),
  trial_id INTEGER,
  session_time_s REAL NOT NULL,
  recorded_utc TEXT NOT NULL,
  operator_name TEXT NOT NULL,
  change_confirmed INTEGER NOT NULL CHECK (change_confirmed IN (0, 1)),
  drifted INTEGER NOT NULL CHECK (drifted IN (0, 1)),
  sample_count INTEGER CHECK (sample_count >= 1),
  column_names TEXT NOT NULL CHECK (column_names <> ''),
  mean_float64 BLOB NOT NULL,
  sd_float64 BLOB NOT NULL,
  UNIQUE (session_id, id),
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id),
  CHECK (length(mean_float64) = 8 * (1 + length(column_names) -
                                     length(replace(column_names, char(10), '')))),
  CHECK (length(sd_float64) = length(mean_float64))
) STRICT)",
          {"CREATE UNIQUE INDEX preparations_of_trial ON preparations (trial_id, kind) WHERE "
           "trial_id IS NOT NULL"}},

    Table{"preparation_references",
          R"(CREATE TABLE preparation_references (
  preparation_id INTEGER NOT NULL REFERENCES preparations (id),
  name TEXT NOT NULL CHECK (name <> ''),
  value ANY NOT NULL CHECK (typeof(value) = 'real'),
  PRIMARY KEY (preparation_id, name)
) STRICT, WITHOUT ROWID)",
          {}},

    Table{"trial_preparations",
          R"(CREATE TABLE trial_preparations (
  trial_id INTEGER NOT NULL,
  preparation_id INTEGER NOT NULL,
  session_id INTEGER NOT NULL,
  PRIMARY KEY (trial_id, preparation_id),
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id),
  FOREIGN KEY (session_id, preparation_id) REFERENCES preparations (session_id, id)
) STRICT, WITHOUT ROWID)",
          {}},

    Table{"signal_groups",
          R"(CREATE TABLE signal_groups (
  trial_id INTEGER NOT NULL REFERENCES trials (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  column_names TEXT NOT NULL,
  PRIMARY KEY (trial_id, position)
) STRICT)",
          {}},

    Table{"signal_blocks",
          R"(CREATE TABLE signal_blocks (
  trial_id INTEGER NOT NULL,
  position INTEGER NOT NULL,
  second INTEGER NOT NULL CHECK (second >= 0),
  row_count INTEGER NOT NULL CHECK (row_count > 0),
  crc32 INTEGER NOT NULL,
  float64_shuffled_zstd BLOB NOT NULL,
  PRIMARY KEY (trial_id, position, second),
  FOREIGN KEY (trial_id, position) REFERENCES signal_groups (trial_id, position)
) STRICT)",
          {}},

    Table{"signal_packs",
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
          {}},

    Table{"measures",
          R"(CREATE TABLE measures (
  id INTEGER PRIMARY KEY,
  trial_id INTEGER NOT NULL REFERENCES trials (id),
  name TEXT NOT NULL CHECK (name <> ''),
  channel TEXT NOT NULL,
  value ANY CHECK (typeof(value) IN ('real', 'null')),
  unit TEXT NOT NULL,
  version INTEGER NOT NULL,
  sample_count INTEGER NOT NULL,
  excluded_count INTEGER NOT NULL,
  reason TEXT NOT NULL
) STRICT)",
          {"CREATE INDEX measures_of_trial ON measures (trial_id)"}},

    Table{"events",
          R"(CREATE TABLE events (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  trial_id INTEGER,
  session_time_s REAL NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''),
  text TEXT NOT NULL,
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id)
) STRICT)",
          {"CREATE INDEX events_of_session ON events (session_id)"}},

    Table{"ratings",
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
          {"CREATE INDEX ratings_of_session ON ratings (session_id)"}},
};

}  // namespace

std::span<const Table> tables() {
  return kTables;
}

std::vector<std::string> statements() {
  std::vector<std::string> all;
  for (const Table& table : kTables) {
    all.emplace_back(table.create);
    for (const char* index : table.indexes)
      if (index != nullptr) all.emplace_back(index);
  }
  for (const char* statement : access_statements()) all.emplace_back(statement);
  for (const char* statement : seal_statements()) all.emplace_back(statement);
  return all;
}

}  // namespace isograsp::storage::schema
