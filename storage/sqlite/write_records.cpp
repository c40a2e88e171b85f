// SPDX-License-Identifier: GPL-3.0-or-later
// Writing, but for trials (write_trial.cpp). Every call is one transaction, synced to the disk
// before it returns.
#include <algorithm>
#include <ctime>
#include <optional>
#include <string>

#include <soci/soci.h>

#include "core/time.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/records/patient_code.hpp"
#include "storage/sqlite/nullable.hpp"
#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

RowId last_id(soci::session& sql, const char* table) {
  long long id = 0;
  if (!sql.get_last_insert_id(table, id)) throw Refusal{failed("no row id"_text, {})};
  return id;
}

Result<void> SqliteStore::repair() {
  std::vector<RowId> running;
  const auto read = database_.guard("opening"_text, [&] {
    RowId id = 0;
    soci::statement select =
        (database_.sql().prepare << "SELECT id FROM trials WHERE status = 'running'",
         soci::into(id));
    select.execute();
    while (select.fetch()) running.push_back(id);
  });
  if (!read) return read.error();
  if (running.empty()) return {};
  const auto lock = RecordingLock::exclusive_if_free(database_.real_path());
  if (!lock) return lock.error();
  if (!lock->held()) return {};  // somebody records: those trials may be theirs
  const auto marked = database_.transact("marking interrupted trials"_text, [&] {
    // Of others nothing is known: they stay as they are, and `db check` names them.
    std::erase_if(running, [this](RowId trial) { return !is_as_sealed("trials", trial); });
    for (const RowId trial : running)
      database_.sql() << "UPDATE trials SET status = 'interrupted', sample_count = "
                         "(SELECT coalesce(sum(row_count), 0) FROM signal_blocks "
                         "WHERE trial_id = trials.id AND position = 0) "
                         "WHERE id = :id AND status = 'running'",
          soci::use(trial);
  });
  if (!marked) return marked.error();
  for (const RowId trial : running) pack_or_note(trial);
  return {};
}

bool SqliteStore::is_as_sealed(const char* table, RowId row) {
  return database_.seals() == nullptr ||
         database_.seals()->is_as_sealed(table, {std::to_string(row)});
}

std::string SqliteStore::new_uuid(const std::string& name) const {
  return database_.is_scratch() ? uuid_of(name) : random_uuid();
}

Result<PatientRecord> SqliteStore::add_patient(const std::string& code,
                                               const std::string& created_utc,
                                               const std::string& uuid) {
  if (const auto allowed = check_patient_code(code); !allowed) return allowed.error();
  PatientRecord patient{0, code, created_utc.empty() ? utc_text(std::time(nullptr)) : created_utc,
                        uuid.empty() ? new_uuid(code + "\n" + created_utc) : uuid};
  const auto done = database_.transact("adding a patient"_text, [&] {
    soci::session& sql = database_.sql();
    std::string present;
    sql << "SELECT code FROM patients WHERE code = :code", soci::use(code), soci::into(present);
    if (sql.got_data())
      throw Refusal{refused("patient %1 exists already"_text(present), "choose another code"_text)
                        .at(path())};
    const std::string salt = database_.is_scratch() ? "zeroblob(16)" : "randomblob(16)";
    sql << "INSERT INTO patients (code, created_utc, uuid, salt) "
           "VALUES (:code, :created, :uuid, " +
               salt + ")",
        soci::use(patient.code), soci::use(patient.created_utc), soci::use(patient.uuid);
    patient.id = last_id(sql, "patients");
  });
  if (!done) return done.error();
  return patient;
}

Result<void> SqliteStore::remove_patient(RowId patient) {
  return database_.transact("removing a patient"_text, [&] {
    require("patients", "patient"_text, patient);
    soci::session& sql = database_.sql();
    // Whatever table refers to people, also one that is added later.
    std::vector<std::string> rows_of_person;
    std::string table;
    std::string column;
    soci::statement refers =
        (sql.prepare << "SELECT m.name, f.\"from\" FROM sqlite_master m, "
                        "pragma_foreign_key_list(m.name) f "
                        "WHERE m.type = 'table' AND f.\"table\" = 'patients' ORDER BY m.name",
         soci::into(table), soci::into(column));
    refers.execute();
    while (refers.fetch())
      rows_of_person.push_back("SELECT count(*) FROM " + table + " WHERE " + column + " = :id");
    for (const std::string& count : rows_of_person) {
      int rows = 0;
      sql << count, soci::use(patient), soci::into(rows);
      if (rows > 0)
        throw Refusal{refused("something is stored of this person already"_text,
                              "keep the person; what was stored by mistake can be corrected"_text)
                          .at(path())};
    }
    sql << "DELETE FROM patients WHERE id = :id", soci::use(patient);
  });
}

Result<RowId> SqliteStore::begin_session(const SessionRecord& session,
                                         std::span<const SessionAnswer> answers) {
  RowId id = 0;
  const std::string started =
      session.started_utc.empty() ? utc_text(std::time(nullptr)) : session.started_utc;
  const std::string seed = std::to_string(session.seed);  // 64 bits without a sign: no SQL type
  const auto done = database_.transact("beginning a session"_text, [&] {
    soci::session& sql = database_.sql();
    std::string patient;
    int before = 0;
    sql << "SELECT uuid, (SELECT count(*) FROM sessions) FROM patients WHERE id = :id",
        soci::use(session.patient_id), soci::into(patient), soci::into(before);
    const std::string uuid =
        session.uuid.empty() ? new_uuid(patient + "\n" + started + "\n" + std::to_string(before))
                             : session.uuid;
    NewRow(sql, "sessions")
        .set("patient_id", session.patient_id)
        .set("uuid", uuid)
        .set("resumes_id", session.resumes_id)
        .set("started_utc", started)
        .set("hand", name_of(session.hand))
        .set("device_uri", session.device_uri)
        .set("device_description", session.device_description)
        .set("calibration", session.calibration)
        .set("simulated", session.simulated)
        .set("recorded", session.recorded)
        .set("provenance", session.provenance)
        .set("protocol_name", session.protocol_name)
        .set("protocol_text", session.protocol_text)
        .set("rate_Hz", session.rate_Hz)
        .set("device_delay_s", session.device_delay_s)
        .set("software_version", session.software_version)
        .set("cpu_features", session.cpu_features)
        .set("seed", seed)
        .set("operator_name", session.operator_name)
        .set("realtime", session.realtime)
        .set("allowed", session.allowed)
        .insert();
    id = last_id(sql, "sessions");
    for (std::size_t i = 0; i < session.sensors.size(); ++i)
      NewRow(sql, "session_sensors")
          .set("session_id", id)
          .set("position", static_cast<std::int64_t>(i))
          .set("name", session.sensors[i].name)
          .set("serial_number", session.sensors[i].serial_number)
          .insert();
    insert_references("session", id, session.references);
    insert_answers(id, answers);
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::end_session(RowId session, const std::string& ended_utc) {
  return database_.transact("ending a session"_text, [&] {
    const std::string ended = ended_utc.empty() ? utc_text(std::time(nullptr)) : ended_utc;
    soci::statement update =
        (database_.sql().prepare << "UPDATE sessions SET ended_utc = :ended WHERE id = :id",
         soci::use(ended), soci::use(session));
    update.execute(true);
    if (update.get_affected_rows() != 1)
      throw Refusal{refused("there is no session %1"_text(session), "begin one"_text).at(path())};
  });
}

Result<RowId> SqliteStore::add_preparation(const PreparationRecord& preparation) {
  RowId id = 0;
  const auto done = database_.transact("storing a preparation"_text, [&] {
    NewRow(database_.sql(), "preparations")
        .set("session_id", preparation.session_id)
        .set("kind", preparation.kind)
        .set("trial_id", preparation.trial_id)
        .set("session_time_s", preparation.session_time_s)
        .set("recorded_utc", preparation.recorded_utc)
        .set("operator_name", preparation.operator_name)
        .set("change_confirmed", preparation.change_confirmed)
        .set("drifted", preparation.drifted)
        .set("sample_count", preparation.samples)
        .set("column_names", as_lines(preparation.columns))
        .set("mean_float64", preparation.mean)
        .set("sd_float64", preparation.sd)
        .insert();
    id = last_id(database_.sql(), "preparations");
    insert_references("preparation", id, preparation.references);
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::save_copy(const std::string& to) {
  return SqliteStore::backup(to);
}

Result<EventRecord> SqliteStore::as_stored(const EventPlace&, const EventRecord& event) {
  return event;
}

Result<std::string> SqliteStore::database_id() {
  std::string id;
  const auto read = database_.guard("reading who the database is"_text, [&] {
    database_.sql() << "SELECT database_id FROM access_settings", soci::into(id);
  });
  if (!read) return read.error();
  return id;
}

Result<void> SqliteStore::add_event(RowId session, const EventRecord& event) {
  return database_.transact("storing an event"_text, [&] {
    NewRow(database_.sql(), "events")
        .set("session_id", session)
        .set("trial_id", event.trial_id)
        .set("session_time_s", event.session_time_s)
        .set("kind", event.kind)
        .set("text", event.text)
        .insert();
  });
}

Result<RowId> SqliteStore::add_rating(const RatingRecord& rating) {
  RowId id = 0;
  const auto done = database_.transact("storing a rating"_text, [&] {
    NewRow(database_.sql(), "ratings")
        .set("session_id", rating.session_id)
        .set("trial_id", rating.trial_id)
        .set("session_time_s", rating.session_time_s)
        .set("recorded_utc", rating.recorded_utc)
        .set("effort", rating.effort)
        .set("pain", rating.pain)
        .insert();
    id = last_id(database_.sql(), "ratings");
    write_shoulder_pain(rating);
  });
  if (!done) return done.error();
  return id;
}

/// In the place of what was said before at the time of this rating.
void SqliteStore::write_shoulder_pain(const RatingRecord& rating) {
  const std::string kind = kShoulderPainEvent;
  database_.sql() << "DELETE FROM events WHERE session_id = :session AND kind = :kind AND "
                     "session_time_s = :time",
      soci::use(rating.session_id), soci::use(kind), soci::use(rating.session_time_s);
  if (!rating.shoulder_pain) return;
  constexpr int kMostOfScale = 10;
  if (*rating.shoulder_pain < 0 || *rating.shoulder_pain > kMostOfScale)
    throw Refusal{refused("shoulder pain cannot be %1"_text(*rating.shoulder_pain),
                          "give a number from 0 to %1"_text(kMostOfScale))
                      .about("shoulder_pain")};
  NewRow(database_.sql(), "events")
      .set("session_id", rating.session_id)
      .set("session_time_s", rating.session_time_s)
      .set("kind", kind)
      .set("text", std::to_string(*rating.shoulder_pain))
      .insert();
}

Result<void> SqliteStore::correct_rating(const RatingRecord& rating) {
  const auto words = [](const RatingRecord& one) {
    return "effort " + std::to_string(one.effort) + ", pain " + std::to_string(one.pain) +
           (one.shoulder_pain ? ", shoulder pain " + std::to_string(*one.shoulder_pain) : "");
  };
  const auto all = ratings(rating.session_id);
  if (!all) return all.error();
  const auto before = std::ranges::find(*all, rating.id, &RatingRecord::id);
  if (before == all->end())
    return refused("rating %1 does not exist"_text(rating.id),
                   "check its number and that of its session"_text)
        .at(path());
  return database_.transact("correcting a rating"_text, [&] {
    soci::session& sql = database_.sql();
    sql << "UPDATE ratings SET effort = :effort, pain = :pain WHERE id = :id",
        soci::use(rating.effort), soci::use(rating.pain), soci::use(rating.id);
    RatingRecord now = rating;
    now.session_time_s = before->session_time_s;
    write_shoulder_pain(now);
    const std::string kind = kCorrectionEvent;
    const std::string text = "Rating corrected: " + words(rating) + "; before: " + words(*before);
    sql << "INSERT INTO events (session_id, trial_id, session_time_s, kind, text) "
           "SELECT session_id, trial_id, :time, :kind, :text FROM ratings WHERE id = :id",
        soci::use(rating.session_time_s), soci::use(kind), soci::use(text), soci::use(rating.id);
  });
}

Result<void> SqliteStore::mark_helped(RowId trial, bool helped) {
  const int mark = helped ? 1 : 0;
  return database_.transact(
      "marking a trial"_text, [&] {
        soci::statement update =
            (database_.sql().prepare
                 << "UPDATE trials SET helped = :mark WHERE id = :id AND status <> 'running'",
             soci::use(mark), soci::use(trial));
        update.execute(true);
        if (update.get_affected_rows() != 1)
          throw Refusal{refused("trial %1 has not ended or does not exist"_text(trial),
                                "wait for its end"_text)
                            .at(path())};
      });
}

}  // namespace isograsp::storage
