// SPDX-License-Identifier: GPL-3.0-or-later
// Opening and writing. Every call is one transaction, synced to the disk before it returns.
#include "storage/session_store.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>

#include <soci/soci.h>
#include <unistd.h>

#include "core/time.hpp"
#include "storage/block_codec.hpp"
#include "storage/content_hash.hpp"
#include "storage/guarded_store.hpp"
#include "storage/sqlite_store.hpp"

namespace isograsp {

RowId last_id(soci::session& sql, const char* table) {
  long long id = 0;
  if (!sql.get_last_insert_id(table, id))
    throw Refusal{{Error::Code::failed, "no row id", "", "", 0, ""}};
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

/// Nothing becomes NULL.
struct Optional {
  explicit Optional(const std::optional<double>& from)
      : value(from.value_or(0.0)), present(from ? soci::i_ok : soci::i_null) {}
  double value;
  soci::indicator present;
};

soci::indicator null_if_zero(RowId id) {
  return id == 0 ? soci::i_null : soci::i_ok;
}

}  // namespace

std::string_view name_of(TrialStatus status) noexcept {
  switch (status) {
    case TrialStatus::running: return "running";
    case TrialStatus::completed: return "completed";
    case TrialStatus::aborted: return "aborted";
    case TrialStatus::interrupted: return "interrupted";
  }
  return "";
}

struct SqliteStore::BlockInsert {
  explicit BlockInsert(soci::session& sql)
      : data(sql),
        statement((sql.prepare << "INSERT INTO signal_blocks (trial_id, position, second, "
                                  "row_count, crc32, float64_shuffled_zstd) "
                                  "VALUES (:trial, :position, :second, :rows, :crc, :data)",
                   soci::use(trial), soci::use(position), soci::use(second), soci::use(row_count),
                   soci::use(crc), soci::use(data))) {}
  long long trial = 0;
  int position = 0;
  int second = 0;
  long long row_count = 0;
  long long crc = 0;
  soci::blob data;
  soci::statement statement;
};

SqliteStore::SqliteStore(Database database) : database_(std::move(database)) {}
SqliteStore::~SqliteStore() = default;

Error SqliteStore::refuse(std::string what, std::string remedy) const {
  return {Error::Code::bad_input, std::move(what), std::move(remedy), path(), 0, ""};
}

Result<std::unique_ptr<SessionStore>> SessionStore::open(const std::string& path, Open how) {
  auto database = Database::open(path, how);
  if (!database) return database.error();
  auto store = make_guarded_store(*std::move(database), how != Open::read_only);
  if (!store) return store.error();
  if (how != Open::read_only)
    if (const auto repaired = (*store)->repair(); !repaired) return repaired.error();
  return std::unique_ptr<SessionStore>(*std::move(store));
}

Result<std::unique_ptr<SessionStore>> SessionStore::open_to_read(const std::string& path) {
  auto store = open(path, Open::existing);
  if (store || access(path.c_str(), R_OK) != 0) return store;
  auto reader = open(path, Open::read_only);
  return reader ? std::move(reader) : std::move(store);
}

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
                                               const std::string& created_utc) {
  if (const auto allowed = check_patient_code(code); !allowed) return allowed.error();
  PatientRecord patient{0, code, created_utc.empty() ? utc_text(std::time(nullptr)) : created_utc,
                        new_uuid(code + "\n" + created_utc)};
  const auto done = database_.transact("adding a patient", [&] {
    soci::session& sql = database_.sql();
    std::string present;
    sql << "SELECT code FROM patients WHERE code = :code", soci::use(code), soci::into(present);
    if (sql.got_data())
      throw Refusal{refuse("patient " + present + " exists already", "choose another code")};
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
  Optional ceiling(session.ceiling_N);
  const auto done = database_.transact("beginning a session", [&] {
    soci::session& sql = database_.sql();
    std::string patient;
    int before = 0;
    sql << "SELECT uuid, (SELECT count(*) FROM sessions) FROM patients WHERE id = :id",
        soci::use(session.patient_id), soci::into(patient), soci::into(before);
    const std::string uuid = new_uuid(patient + "\n" + started + "\n" + std::to_string(before));
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
      throw Refusal{refuse("there is no session " + std::to_string(session), "begin one")};
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
    Optional change(zero.change_N);
    Optional drift(zero.drift_N);
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
    Optional since(rest.since_strapping_s);
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

Result<RowId> SqliteStore::begin_trial(const TrialRecord& trial) {
  if (recording_) return refuse("a trial is being recorded", "end it before the next one begins");
  if (trial.groups.empty()) return refuse("the trial has no signals", "give at least one group");
  Recording recording;
  for (const SignalGroup& group : trial.groups) {
    const bool nameless =
        std::any_of(group.columns.begin(), group.columns.end(),
                    [](const auto& c) { return c.empty() || c.find('\n') != std::string::npos; });
    if (group.columns.empty() || nameless)
      return refuse("signal group '" + group.name + "' has no columns or one without a name",
                    "name every column");
    recording.column_counts.push_back(group.columns.size());
  }
  auto lock = RecordingLock::shared(database_.real_path());
  if (!lock) return lock.error();
  recording.lock = std::move(*lock);

  const int practice = trial.practice ? 1 : 0;
  auto zero_present = null_if_zero(trial.zero_id);
  Optional thumb(trial.threshold_N[0]);
  Optional index(trial.threshold_N[1]);
  Optional middle(trial.threshold_N[2]);
  const std::string seed = trial.seed == 0 ? "" : std::to_string(trial.seed);
  const TrialPlace place = trial.place.value_or(TrialPlace{});
  auto place_present = trial.place ? soci::i_ok : soci::i_null;
  const auto done = database_.transact("beginning a trial", [&] {
    soci::session& sql = database_.sql();
    std::string of_session;
    sql << "SELECT rate_Hz, uuid FROM sessions WHERE id = :id", soci::use(trial.session_id),
        soci::into(recording.rate_Hz), soci::into(of_session);
    if (!sql.got_data())
      throw Refusal{refuse("there is no session " + std::to_string(trial.session_id), "begin one")};
    const std::string uuid = new_uuid(of_session + "\n" + std::to_string(trial.number));
    sql << "INSERT INTO trials (session_id, number, task_name, task_version, task_text, "
           "scene_text, practice, session_time_s, status, maximum_force_N, resting_force_N, "
           "zero_id, thumb_threshold_N, index_threshold_N, middle_threshold_N, seed, step, "
           "step_task, uuid) "
           "VALUES (:session, :number, :task, :version, :task_text, :scene_text, "
           ":practice, :time, 'running', :maximum, :resting, :zero, :thumb, :index, :middle, "
           ":seed, :step, :step_task, :uuid)",
        soci::use(trial.session_id), soci::use(trial.number), soci::use(trial.task_name),
        soci::use(trial.task_version), soci::use(trial.task_text), soci::use(trial.scene_text),
        soci::use(practice), soci::use(trial.session_time_s), soci::use(trial.maximum_force_N),
        soci::use(trial.resting_force_N), soci::use(trial.zero_id, zero_present),
        soci::use(thumb.value, thumb.present), soci::use(index.value, index.present),
        soci::use(middle.value, middle.present), soci::use(seed),
        soci::use(place.step, place_present), soci::use(place.task, place_present), soci::use(uuid);
    recording.trial = last_id(sql, "trials");
    for (std::size_t g = 0; g < trial.groups.size(); ++g) {
      const int position = static_cast<int>(g);
      std::string names;
      for (const auto& column : trial.groups[g].columns)
        names += (names.empty() ? "" : "\n") + column;
      sql << "INSERT INTO signal_groups (trial_id, position, name, column_names) "
             "VALUES (:trial, :position, :name, :names)",
          soci::use(recording.trial), soci::use(position), soci::use(trial.groups[g].name),
          soci::use(names);
    }
  });
  if (!done) return done.error();
  recording_ = std::move(recording);
  return recording_->trial;
}

Result<void> SqliteStore::check_blocks(int second,
                                       std::span<const std::vector<double>> rows) const {
  const Recording& now = *recording_;
  if (second != now.next_second)
    return refuse(
        "second " + std::to_string(second) + " came instead of " + std::to_string(now.next_second),
        "append the seconds in order");
  if (now.short_block_seen)
    return refuse("a second follows one that was not full", "end the trial after the last second");
  if (rows.size() != now.column_counts.size())
    return refuse("blocks for " + std::to_string(rows.size()) + " instead of " +
                      std::to_string(now.column_counts.size()) + " groups",
                  "give all groups of the trial at once");
  const std::size_t row_count = rows[0].size() / now.column_counts[0];
  for (std::size_t g = 0; g < rows.size(); ++g)
    if (row_count == 0 || rows[g].size() != row_count * now.column_counts[g])
      return refuse("the groups of second " + std::to_string(second) +
                        " do not hold the same number of whole rows",
                    "give every group one row per sample");
  if (static_cast<double>(row_count) > std::ceil(now.rate_Hz))
    return refuse("second " + std::to_string(second) + " holds " + std::to_string(row_count) +
                      " rows, more than one second",
                  "append one second at a time");
  return {};
}

Result<void> SqliteStore::append_blocks(RowId trial, int second,
                                        std::span<const std::vector<double>> rows) {
  if (!recording_ || recording_->trial != trial)
    return refuse("trial " + std::to_string(trial) + " is not being recorded", "begin it first");
  if (const auto sound = check_blocks(second, rows); !sound) return sound.error();
  const auto row_count = static_cast<long long>(rows[0].size() / recording_->column_counts[0]);
  const auto done = database_.transact("storing a second of signals", [&] {
    if (!block_insert_) block_insert_ = std::make_unique<BlockInsert>(database_.sql());
    BlockInsert& insert = *block_insert_;
    insert.trial = trial;
    insert.second = second;
    insert.row_count = row_count;
    for (std::size_t g = 0; g < rows.size(); ++g) {
      const std::string bytes = encode_block(rows[g], recording_->column_counts[g]);
      insert.position = static_cast<int>(g);
      insert.crc = crc32(bytes);
      if (insert.data.get_len() > 0) insert.data.trim(0);
      insert.data.append(bytes.data(), bytes.size());
      insert.statement.execute(true);
    }
  });
  if (!done) {
    block_insert_.reset();  // a statement that failed half-way is not used again
    return done.error();
  }
  ++recording_->next_second;
  recording_->short_block_seen = static_cast<double>(row_count) < std::floor(recording_->rate_Hz);
  return {};
}

Result<void> SqliteStore::end_trial(const TrialRecord& end, std::span<const Measure> measures) {
  if (!recording_ || recording_->trial != end.id)
    return refuse("trial " + std::to_string(end.id) + " is not being recorded", "begin it first");
  if (end.status == TrialStatus::running)
    return refuse("a trial cannot end as running", "say completed or aborted");
  for (const Measure& measure : measures)
    if (measure.value && !std::isfinite(*measure.value))
      return refuse("measure " + measure.name + " is not a finite number",
                    "leave the value out and give the reason");
  const std::string status(name_of(end.status));
  Optional age(end.display_age_s);
  Optional gain(end.visual_gain_deg_per_N);
  Optional distance(end.viewing_distance_m);
  const auto done = database_.transact("closing a trial", [&] {
    soci::session& sql = database_.sql();
    sql << "UPDATE trials SET status = :status, dropped_count = :dropped, "
           "worst_lateness_s = :lateness, worst_compute_s = :compute, health_json = :health, "
           "timing_json = :timing, display_age_s = :age, visual_gain_deg_per_N = :gain, "
           "viewing_distance_m = :distance, "
           "sample_count = (SELECT coalesce(sum(row_count), 0) FROM signal_blocks "
           "WHERE trial_id = trials.id AND position = 0) WHERE id = :id",
        soci::use(status), soci::use(end.dropped), soci::use(end.worst_lateness_s),
        soci::use(end.worst_compute_s), soci::use(end.health_json), soci::use(end.timing_json),
        soci::use(age.value, age.present), soci::use(gain.value, gain.present),
        soci::use(distance.value, distance.present), soci::use(end.id);
    for (const Measure& measure : measures) {
      const double value = measure.value.value_or(0.0);
      auto value_present = measure.value ? soci::i_ok : soci::i_null;
      sql << "INSERT INTO measures (trial_id, name, channel, value, unit, version, sample_count, "
             "excluded_count, reason) VALUES (:trial, :name, :channel, :value, :unit, :version, "
             ":samples, :excluded, :reason)",
          soci::use(end.id), soci::use(measure.name), soci::use(measure.channel),
          soci::use(value, value_present), soci::use(measure.unit), soci::use(measure.version),
          soci::use(measure.samples), soci::use(measure.excluded), soci::use(measure.reason);
    }
  });
  if (!done) return done.error();
  recording_.reset();
  pack_or_say(end.id);
  return {};
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

Result<void> SqliteStore::mark_helped(RowId trial, bool helped) {
  const int mark = helped ? 1 : 0;
  return database_.transact("marking a trial", [&] {
    soci::statement update =
        (database_.sql().prepare
             << "UPDATE trials SET helped = :mark WHERE id = :id AND status <> 'running'",
         soci::use(mark), soci::use(trial));
    update.execute(true);
    if (update.get_affected_rows() != 1)
      throw Refusal{refuse("trial " + std::to_string(trial) + " has not ended or does not exist",
                           "wait for its end")};
  });
}

}  // namespace isograsp
