// SPDX-License-Identifier: GPL-3.0-or-later
// Writing, but for trials (write_trial.cpp). Every call is one transaction, synced to the disk
// before it returns.
#include <array>
#include <ctime>

#include <soci/soci.h>

#include "core/time.hpp"
#include "storage/crypto/content_hash.hpp"
#include "storage/records/patient_code.hpp"
#include "storage/sqlite/nullable.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

RowId last_id(soci::session& sql, const char* table) {
  long long id = 0;
  if (!sql.get_last_insert_id(table, id)) throw Refusal{failed("no row id", "")};
  return id;
}

namespace {

/// 18 float64, little-endian: thumb, index, middle; Fx Fy Fz Tx Ty Tz.
std::string pack(const std::array<Vec6, kFingerCount>& wrenches) {
  std::string bytes;
  for (const Vec6& wrench : wrenches)
    bytes.append(reinterpret_cast<const char*>(wrench.data()), 6 * sizeof(double));
  return bytes;
}

}  // namespace

Result<void> SqliteStore::repair() {
  std::vector<RowId> running;
  const auto read = database_.guard("opening", [&] {
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
  const auto marked = database_.transact("marking interrupted trials", [&] {
    database_.sql() << "UPDATE trials SET status = 'interrupted', sample_count = "
                       "(SELECT coalesce(sum(row_count), 0) FROM signal_blocks "
                       "WHERE trial_id = trials.id AND position = 0) WHERE status = 'running'";
  });
  if (!marked) return marked.error();
  for (const RowId trial : running) pack_or_say(trial);
  return {};
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
  const auto done = database_.transact("adding a patient", [&] {
    soci::session& sql = database_.sql();
    std::string present;
    sql << "SELECT code FROM patients WHERE code = :code", soci::use(code), soci::into(present);
    if (sql.got_data())
      throw Refusal{
          refused("patient " + present + " exists already", "choose another code").at(path())};
    sql << "INSERT INTO patients (code, created_utc, uuid) VALUES (:code, :created, :uuid)",
        soci::use(patient.code), soci::use(patient.created_utc), soci::use(patient.uuid);
    patient.id = last_id(sql, "patients");
  });
  if (!done) return done.error();
  return patient;
}

Result<RowId> SqliteStore::begin_session(const SessionRecord& session,
                                         std::span<const SessionAnswer> answers) {
  RowId id = 0;
  const std::string started =
      session.started_utc.empty() ? utc_text(std::time(nullptr)) : session.started_utc;
  const std::string hand(name_of(session.hand));
  const std::string seed = std::to_string(session.seed);  // 64 bits without a sign: no SQL type
  const int simulated = session.simulated ? 1 : 0;
  const int recorded = session.recorded ? 1 : 0;
  const std::string serials = serials_text(session.serial_numbers);
  auto resumes_present = null_if_zero(session.resumes_id);
  NullableNumber ceiling(session.ceiling_N);
  const auto done = database_.transact("beginning a session", [&] {
    soci::session& sql = database_.sql();
    std::string patient;
    int before = 0;
    sql << "SELECT uuid, (SELECT count(*) FROM sessions) FROM patients WHERE id = :id",
        soci::use(session.patient_id), soci::into(patient), soci::into(before);
    const std::string uuid =
        session.uuid.empty() ? new_uuid(patient + "\n" + started + "\n" + std::to_string(before))
                             : session.uuid;
    sql << "INSERT INTO sessions (patient_id, started_utc, hand, device_uri, device_description, "
           "simulated, recorded, provenance, protocol_name, protocol_text, rate_Hz, "
           "device_delay_s, software_version, cpu_features, seed, device_serials, "
           "operator_name, realtime, resumes_id, allowed, ceiling_N, calibration, uuid) "
           "VALUES (:patient, :started, :hand, :uri, :description, :simulated, :recorded, "
           ":provenance, :protocol, :protocol_text, :rate, :delay, :version, :cpu, :seed, "
           ":serials, :operator, :realtime, :resumes, :allowed, :ceiling, :calibration, :uuid)",
        soci::use(session.patient_id), soci::use(started), soci::use(hand),
        soci::use(session.device_uri), soci::use(session.device_description), soci::use(simulated),
        soci::use(recorded), soci::use(session.provenance), soci::use(session.protocol_name),
        soci::use(session.protocol_text), soci::use(session.rate_Hz),
        soci::use(session.device_delay_s), soci::use(session.software_version),
        soci::use(session.cpu_features), soci::use(seed), soci::use(serials),
        soci::use(session.operator_name), soci::use(session.realtime),
        soci::use(session.resumes_id, resumes_present), soci::use(session.allowed),
        soci::use(ceiling.value, ceiling.present), soci::use(session.calibration), soci::use(uuid);
    id = last_id(sql, "sessions");
    insert_answers(id, answers);
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::end_session(RowId session, const std::string& ended_utc) {
  return database_.transact("ending a session", [&] {
    const std::string ended = ended_utc.empty() ? utc_text(std::time(nullptr)) : ended_utc;
    soci::statement update =
        (database_.sql().prepare << "UPDATE sessions SET ended_utc = :ended WHERE id = :id",
         soci::use(ended), soci::use(session));
    update.execute(true);
    if (update.get_affected_rows() != 1)
      throw Refusal{
          refused("there is no session " + std::to_string(session), "begin one").at(path())};
  });
}

Result<RowId> SqliteStore::add_zero(const InstrumentZeroRecord& zero) {
  RowId id = 0;
  const auto done = database_.transact("storing an instrument zero", [&] {
    soci::session& sql = database_.sql();
    const std::string mean_bytes = pack(zero.mean);
    const std::string sd_bytes = pack(zero.sd);
    soci::blob mean(sql);
    soci::blob sd(sql);
    mean.append(mean_bytes.data(), mean_bytes.size());
    sd.append(sd_bytes.data(), sd_bytes.size());
    NullableNumber change(zero.change_N);
    NullableNumber drift(zero.drift_N);
    const int confirmed = zero.change_confirmed ? 1 : 0;
    const int drifted = zero.drifted ? 1 : 0;
    if (zero.drift_N)
      sql << "UPDATE trials SET zero_drift_N = :drift, zero_drifted = :drifted "
             "WHERE session_id = :session AND zero_id = "
             "(SELECT max(id) FROM instrument_zeros WHERE session_id = :same_session)",
          soci::use(drift.value), soci::use(drifted), soci::use(zero.session_id),
          soci::use(zero.session_id);
    sql << "INSERT INTO instrument_zeros (session_id, session_time_s, mean_N_Nm, sd_N_Nm, "
           "recorded_utc, operator_name, change_N, change_confirmed, drift_N) "
           "VALUES (:session, :time, :mean, :sd, :utc, :operator, :change, :confirmed, :drift)",
        soci::use(zero.session_id), soci::use(zero.session_time_s), soci::use(mean), soci::use(sd),
        soci::use(zero.recorded_utc), soci::use(zero.operator_name),
        soci::use(change.value, change.present), soci::use(confirmed),
        soci::use(drift.value, drift.present);
    id = last_id(sql, "instrument_zeros");
  });
  if (!done) return done.error();
  return id;
}

Result<RowId> SqliteStore::add_resting_force(const RestingForceRecord& rest) {
  RowId id = 0;
  const auto done = database_.transact("storing a resting force", [&] {
    soci::session& sql = database_.sql();
    const std::string mean_bytes = pack(rest.mean);
    const std::string sd_bytes = pack(rest.sd);
    soci::blob mean(sql);
    soci::blob sd(sql);
    mean.append(mean_bytes.data(), mean_bytes.size());
    sd.append(sd_bytes.data(), sd_bytes.size());
    NullableNumber since(rest.since_strapping_s);
    sql << "INSERT INTO resting_forces (session_id, trial_id, session_time_s, recorded_utc, "
           "operator_name, duration_s, since_strapping_s, sample_count, mean_N_Nm, sd_N_Nm) "
           "VALUES (:session, :trial, :time, :utc, :operator, :duration, :since, :samples, "
           ":mean, :sd)",
        soci::use(rest.session_id), soci::use(rest.trial_id), soci::use(rest.session_time_s),
        soci::use(rest.recorded_utc), soci::use(rest.operator_name), soci::use(rest.duration_s),
        soci::use(since.value, since.present), soci::use(rest.samples), soci::use(mean),
        soci::use(sd);
    id = last_id(sql, "resting_forces");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::save_copy(const std::string& to) {
  return SqliteStore::backup(to);
}

Result<EventRecord> SqliteStore::as_stored(const std::string&, const EventRecord& event) {
  return event;
}

Result<std::string> SqliteStore::database_id() {
  std::string id;
  const auto read = database_.guard("reading who the database is", [&] {
    database_.sql() << "SELECT database_id FROM access_settings", soci::into(id);
  });
  if (!read) return read.error();
  return id;
}

Result<void> SqliteStore::add_event(RowId session, const EventRecord& event) {
  auto trial_present = null_if_zero(event.trial_id);
  return database_.transact("storing an event", [&] {
    database_.sql() << "INSERT INTO events (session_id, trial_id, session_time_s, kind, text) "
                       "VALUES (:session, :trial, :time, :kind, :text)",
        soci::use(session), soci::use(event.trial_id, trial_present),
        soci::use(event.session_time_s), soci::use(event.kind), soci::use(event.text);
  });
}

Result<RowId> SqliteStore::add_rating(const RatingRecord& rating) {
  RowId id = 0;
  auto trial_present = null_if_zero(rating.trial_id);
  const auto done = database_.transact("storing a rating", [&] {
    soci::session& sql = database_.sql();
    sql << "INSERT INTO ratings (session_id, trial_id, session_time_s, recorded_utc, effort, pain) "
           "VALUES (:session, :trial, :time, :utc, :effort, :pain)",
        soci::use(rating.session_id), soci::use(rating.trial_id, trial_present),
        soci::use(rating.session_time_s), soci::use(rating.recorded_utc), soci::use(rating.effort),
        soci::use(rating.pain);
    id = last_id(sql, "ratings");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::correct_rating(const RatingRecord& rating) {
  const auto words = [](int effort, int pain) {
    return "effort " + std::to_string(effort) + ", pain " + std::to_string(pain);
  };
  return database_.transact("correcting a rating", [&] {
    soci::session& sql = database_.sql();
    int effort = 0;
    int pain = 0;
    sql << "SELECT effort, pain FROM ratings WHERE id = :id AND session_id = :session",
        soci::use(rating.id), soci::use(rating.session_id), soci::into(effort), soci::into(pain);
    if (!sql.got_data())
      throw Refusal{refused("rating " + std::to_string(rating.id) + " does not exist",
                            "check its number and that of its session")
                        .at(path())};
    sql << "UPDATE ratings SET effort = :effort, pain = :pain WHERE id = :id",
        soci::use(rating.effort), soci::use(rating.pain), soci::use(rating.id);
    const std::string text = "Rating corrected: " + words(rating.effort, rating.pain) +
                             "; before: " + words(effort, pain);
    sql << "INSERT INTO events (session_id, trial_id, session_time_s, kind, text) "
           "SELECT session_id, trial_id, :time, 'note', :text FROM ratings WHERE id = :id",
        soci::use(rating.session_time_s), soci::use(text), soci::use(rating.id);
  });
}

Result<void> SqliteStore::mark_helped(RowId trial, bool helped) {
  const int mark = helped ? 1 : 0;
  return database_.transact("marking a trial", [&] {
    soci::statement update =
        (database_.sql().prepare
             << "UPDATE trials SET helped = :mark WHERE id = :id AND status <> 'running'",
         soci::use(mark), soci::use(trial));
    update.execute(true);
    if (update.get_affected_rows() != 1)
      throw Refusal{refused("trial " + std::to_string(trial) + " has not ended or does not exist",
                            "wait for its end")
                        .at(path())};
  });
}

}  // namespace isograsp::storage
