// SPDX-License-Identifier: GPL-3.0-or-later
// STRICT refuses a value of the wrong kind. `ANY … typeof 'real'` is a float64 that may be
// negative: a REAL column would turn -0.0 into 0.0. `date(…, '+0 days')` reckons the date: 30
// February becomes another day, so it is not what was given.
#include "storage/file/schema.hpp"

#include <array>
#include <vector>

#include "storage/file/open_mode.hpp"
#include "storage/file/schema_access.hpp"

namespace isograsp::storage::schema {

namespace {

const std::array<const char*, 12> kToFormat1{
    R"(CREATE TABLE patients (
  id INTEGER PRIMARY KEY,
  code TEXT NOT NULL UNIQUE COLLATE NOCASE CHECK (length(code) BETWEEN 2 AND 32),
  created_utc TEXT NOT NULL
) STRICT)",

    R"(CREATE TABLE sessions (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  started_utc TEXT NOT NULL,
  ended_utc TEXT NOT NULL DEFAULT '',
  hand TEXT NOT NULL CHECK (hand IN ('right', 'left')),
  device_uri TEXT NOT NULL,
  device_description TEXT NOT NULL,
  simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
  recorded INTEGER NOT NULL CHECK (recorded IN (0, 1)),
  provenance TEXT NOT NULL,
  protocol_name TEXT NOT NULL,
  protocol_text TEXT NOT NULL,
  rate_Hz REAL NOT NULL CHECK (rate_Hz > 0),
  device_delay_s REAL NOT NULL CHECK (device_delay_s >= 0),
  software_version TEXT NOT NULL,
  cpu_features TEXT NOT NULL,
  seed TEXT NOT NULL
) STRICT)",

    "CREATE INDEX sessions_of_patient ON sessions (patient_id)",

    R"(CREATE TABLE instrument_zeros (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  session_time_s REAL NOT NULL,
  mean_N_Nm BLOB NOT NULL CHECK (length(mean_N_Nm) = 144),
  sd_N_Nm BLOB NOT NULL CHECK (length(sd_N_Nm) = 144),
  UNIQUE (session_id, id)
) STRICT)",

    R"(CREATE TABLE trials (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  number INTEGER NOT NULL CHECK (number >= 1),
  task_name TEXT NOT NULL,
  task_version INTEGER NOT NULL,
  task_text TEXT NOT NULL,
  scene_text TEXT NOT NULL,
  practice INTEGER NOT NULL CHECK (practice IN (0, 1)),
  session_time_s REAL NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('running', 'completed', 'aborted', 'interrupted')),
  maximum_force_N REAL NOT NULL,
  resting_force_N ANY NOT NULL CHECK (typeof(resting_force_N) = 'real'),
  zero_id INTEGER,
  sample_count INTEGER CHECK (sample_count >= 0),
  dropped_count INTEGER NOT NULL DEFAULT 0 CHECK (dropped_count >= 0),
  worst_lateness_s REAL NOT NULL DEFAULT 0,
  worst_compute_s REAL NOT NULL DEFAULT 0,
  health_json TEXT NOT NULL DEFAULT '',
  UNIQUE (session_id, number),
  UNIQUE (session_id, id),
  FOREIGN KEY (session_id, zero_id) REFERENCES instrument_zeros (session_id, id),
  CHECK ((status = 'running') = (sample_count IS NULL))
) STRICT)",

    "CREATE INDEX running_trials ON trials (id) WHERE status = 'running'",

    R"(CREATE TABLE signal_groups (
  trial_id INTEGER NOT NULL REFERENCES trials (id),
  position INTEGER NOT NULL CHECK (position >= 0),
  name TEXT NOT NULL,
  column_names TEXT NOT NULL,
  PRIMARY KEY (trial_id, position)
) STRICT)",

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

    "CREATE INDEX measures_of_trial ON measures (trial_id)",

    R"(CREATE TABLE events (
  id INTEGER PRIMARY KEY,
  session_id INTEGER NOT NULL REFERENCES sessions (id),
  trial_id INTEGER,
  session_time_s REAL NOT NULL,
  kind TEXT NOT NULL CHECK (kind <> ''),
  text TEXT NOT NULL,
  FOREIGN KEY (session_id, trial_id) REFERENCES trials (session_id, id)
) STRICT)",

    "CREATE INDEX events_of_session ON events (session_id)",
};

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
std::span<const char* const> to_format_7() {
  static const std::vector<const char*> statements = [] {
    const auto access = access_statements();
    std::vector<const char*> all(access.begin(), access.end());
    all.push_back(
        "ALTER TABLE patient_profiles ADD COLUMN sex TEXT NOT NULL DEFAULT '' "
        "CHECK (sex IN ('', 'female', 'male', 'other'))");
    all.push_back(
        "ALTER TABLE patient_profiles ADD COLUMN birth_year INTEGER "
        "CHECK (birth_year BETWEEN 1900 AND 2099)");
    return all;
  }();
  return statements;
}

const std::array<std::span<const char* const>, kDatabaseFormat> kFormats{
    kToFormat1, kToFormat2, kToFormat3, kToFormat4, kToFormat5, kToFormat6, to_format_7()};

}  // namespace

std::span<const char* const> statements_to(int format) {
  return kFormats.at(static_cast<std::size_t>(format - 1));
}

}  // namespace isograsp::storage::schema
