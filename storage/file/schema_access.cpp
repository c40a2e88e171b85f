// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/file/schema_access.hpp"

#include <array>

namespace isograsp::storage::schema {

namespace {

constexpr std::array kStatements{
    R"(CREATE TABLE access_settings (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  database_id TEXT NOT NULL CHECK (length(database_id) = 32),
  lock_after_s INTEGER NOT NULL CHECK (lock_after_s BETWEEN 30 AND 86400),
  retention_years INTEGER NOT NULL CHECK (retention_years BETWEEN 0 AND 100)
) STRICT)",

    "INSERT INTO access_settings VALUES (1, lower(hex(randomblob(16))), 600, 10)",

    R"(CREATE TABLE users (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE COLLATE NOCASE CHECK (length(name) BETWEEN 1 AND 64),
  role TEXT NOT NULL CHECK (role IN ('therapist', 'researcher', 'administrator')),
  created_utc TEXT NOT NULL,
  removed_utc TEXT NOT NULL DEFAULT '',
  pin TEXT NOT NULL DEFAULT '',
  pin_failed_count INTEGER NOT NULL DEFAULT 0 CHECK (pin_failed_count >= 0)
) STRICT)",

    R"(CREATE TABLE key_slots (
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL CHECK (kind IN ('passphrase', 'recovery', 'user')),
  user_id INTEGER UNIQUE REFERENCES users (id),
  salt TEXT NOT NULL,
  operations INTEGER NOT NULL,
  memory_bytes INTEGER NOT NULL,
  wrapped TEXT NOT NULL,
  failed_count INTEGER NOT NULL DEFAULT 0 CHECK (failed_count >= 0),
  retry_at_unix_s INTEGER NOT NULL DEFAULT 0,
  CHECK ((kind = 'user') = (user_id IS NOT NULL))
) STRICT)",

    "CREATE UNIQUE INDEX one_slot_of_a_kind ON key_slots (kind) WHERE kind <> 'user'",

    R"(CREATE TABLE identities (
  patient_id INTEGER PRIMARY KEY REFERENCES patients (id),
  changed_utc TEXT NOT NULL,
  sealed TEXT NOT NULL
) STRICT)",

    R"(CREATE TABLE consents (
  id INTEGER PRIMARY KEY,
  patient_id INTEGER NOT NULL REFERENCES patients (id),
  on_date TEXT NOT NULL CHECK (date(on_date, '+0 days') IS on_date),
  purpose TEXT NOT NULL CHECK (purpose <> ''),
  basis TEXT NOT NULL CHECK (basis <> ''),
  state TEXT NOT NULL CHECK (state IN ('given', 'refused', 'withdrawn')),
  text TEXT NOT NULL,
  recorded_utc TEXT NOT NULL,
  recorded_by TEXT NOT NULL
) STRICT)",

    "CREATE INDEX consents_of_patient ON consents (patient_id)",

    R"(CREATE TABLE restrictions (
  patient_id INTEGER PRIMARY KEY REFERENCES patients (id),
  since_utc TEXT NOT NULL,
  until_date TEXT NOT NULL CHECK (date(until_date, '+0 days') IS until_date),
  requested_by TEXT NOT NULL
) STRICT)",

    R"(CREATE TABLE tombstones (
  id INTEGER PRIMARY KEY,
  code TEXT NOT NULL UNIQUE COLLATE NOCASE,
  erased_utc TEXT NOT NULL,
  erased_by TEXT NOT NULL
) STRICT)",

    // What happened before a key was there to chain it; taken into the log at the next login.
    R"(CREATE TABLE login_failures (
  id INTEGER PRIMARY KEY,
  at_utc TEXT NOT NULL,
  who TEXT NOT NULL
) STRICT)",

    R"(CREATE TABLE audit_log (
  id INTEGER PRIMARY KEY,
  at_utc TEXT NOT NULL,
  actor TEXT NOT NULL,
  role TEXT NOT NULL,
  act TEXT NOT NULL CHECK (act <> ''),
  object TEXT NOT NULL,
  result TEXT NOT NULL CHECK (result IN ('done', 'refused', 'failed')),
  detail TEXT NOT NULL,
  hash TEXT NOT NULL CHECK (length(hash) = 64),
  seals INTEGER NOT NULL DEFAULT 0 CHECK (seals >= 0)
) STRICT)",

    "CREATE TRIGGER audit_log_is_not_changed BEFORE UPDATE ON audit_log "
    "BEGIN SELECT RAISE(ABORT, 'the audit log is only added to'); END",
    "CREATE TRIGGER audit_log_is_not_cut BEFORE DELETE ON audit_log "
    "BEGIN SELECT RAISE(ABORT, 'the audit log is only added to'); END",
    // INSERT OR REPLACE deletes without the trigger above.
    "CREATE TRIGGER audit_log_is_not_replaced BEFORE INSERT ON audit_log "
    "WHEN EXISTS (SELECT 1 FROM audit_log WHERE id = NEW.id) "
    "BEGIN SELECT RAISE(ABORT, 'the audit log is only added to'); END",

    R"(CREATE TABLE audit_anchor (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  count INTEGER NOT NULL CHECK (count >= 0),
  hash TEXT NOT NULL,
  proof TEXT NOT NULL
) STRICT)",
};

// A line for every row that was written, changed or removed (storage/file/row_seals.hpp).
constexpr std::array kSealStatements{
    R"(CREATE TABLE row_seals (
  id INTEGER PRIMARY KEY,
  of_table TEXT NOT NULL CHECK (of_table <> ''),
  of_row TEXT NOT NULL,
  hash BLOB CHECK (length(hash) = 32),
  chain BLOB NOT NULL CHECK (length(chain) = 32)
) STRICT)",

    // Is there any? A database without key slots is asked so.
    "CREATE INDEX row_seals_of_slots ON row_seals (id) WHERE of_table = 'key_slots'",
    "CREATE TRIGGER row_seals_are_not_changed BEFORE UPDATE ON row_seals "
    "BEGIN SELECT RAISE(ABORT, 'seals are only added'); END",
    "CREATE TRIGGER row_seals_are_not_cut BEFORE DELETE ON row_seals "
    "BEGIN SELECT RAISE(ABORT, 'seals are only added'); END",
    "CREATE TRIGGER row_seals_are_not_replaced BEFORE INSERT ON row_seals "
    "WHEN EXISTS (SELECT 1 FROM row_seals WHERE id = NEW.id) "
    "BEGIN SELECT RAISE(ABORT, 'seals are only added'); END",

    R"(CREATE TABLE row_seals_anchor (
  id INTEGER PRIMARY KEY CHECK (id = 1),
  count INTEGER NOT NULL CHECK (count >= 0),
  chain BLOB NOT NULL,
  proof BLOB NOT NULL
) STRICT)",
};

}  // namespace

std::span<const char* const> access_statements() {
  return kStatements;
}

std::span<const char* const> seal_statements() {
  return kSealStatements;
}

}  // namespace isograsp::storage::schema
