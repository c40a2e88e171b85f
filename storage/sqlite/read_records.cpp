// SPDX-License-Identifier: GPL-3.0-or-later
// Reading patients, sessions, trials and their progress. Rows come in the order in which they were
// made.
#include <algorithm>
#include <charconv>
#include <unordered_map>

#include <soci/soci.h>

#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

/// Nothing: both of them.
std::optional<Hand> read_hand(const std::string& name) {
  if (const auto hand = hand_from_name(name)) return hand;
  if (name == name_of(std::optional<Hand>())) return std::nullopt;
  throw Refusal{refused("has a format that this program does not know"_text,
                        "use the program that made it"_text)};
}

TrialStatus read_status(const std::string& name) {
  for (const auto status : {TrialStatus::completed, TrialStatus::aborted, TrialStatus::interrupted})
    if (name == name_of(status)) return status;
  return TrialStatus::running;
}

constexpr int kAnswersSinceFormat = 4;

std::uint64_t read_seed(const std::string& text) {
  std::uint64_t seed = 0;
  std::from_chars(text.data(), text.data() + text.size(), seed);
  return seed;
}

}  // namespace

References SqliteStore::references_of(const char* owner, RowId id) {
  const std::string name(owner);
  References all;
  std::string key;
  double value = 0.0;
  Row row(database_.sql());
  row.get("name", key).get("value", value);
  row.select("FROM " + name + "_references WHERE " + name + "_id = :id", {id});
  while (row.fetch()) all[key] = value;
  return all;
}

void SqliteStore::insert_references(const char* owner, RowId id, const References& references) {
  const std::string name(owner);
  for (const auto& [key, value] : references)
    NewRow(database_.sql(), name + "_references")
        .set(name + "_id", id)
        .set("name", key)
        .set("value", value)
        .insert("ON CONFLICT DO NOTHING");
}

std::vector<PatientRecord> SqliteStore::read_patients(const std::string& code) {
  std::vector<PatientRecord> all;
  PatientRecord one;
  Row row(database_.sql());
  row.get("id", one.id)
      .get("code", one.code)
      .get("created_utc", one.created_utc)
      .get("coalesce(uuid, '')", one.uuid);
  if (code.empty())
    row.select("FROM patients ORDER BY id");
  else
    row.select("FROM patients WHERE code = :code", {code});
  while (row.fetch()) all.push_back(one);
  return all;
}

Result<std::vector<PatientRecord>> SqliteStore::patients() {
  std::vector<PatientRecord> all;
  const auto done = database_.guard("reading patients"_text, [&] { all = read_patients(""); });
  if (!done) return done.error();
  return all;
}

Result<std::optional<PatientRecord>> SqliteStore::find_patient(const std::string& code) {
  std::optional<PatientRecord> found;
  if (code.empty()) return found;
  const auto done = database_.guard("reading patients"_text, [&] {
    const auto all = read_patients(code);
    if (!all.empty()) found = all.front();
  });
  if (!done) return done.error();
  return found;
}

std::vector<SensorRecord> SqliteStore::sensors_of(RowId session) {
  std::vector<SensorRecord> all;
  SensorRecord one;
  Row row(database_.sql());
  row.get("name", one.name).get("serial_number", one.serial_number);
  row.select("FROM session_sensors WHERE session_id = :session ORDER BY position", {session});
  while (row.fetch()) all.push_back(one);
  return all;
}

std::vector<SessionRecord> SqliteStore::read_sessions(const std::string& where) {
  std::vector<SessionRecord> all;
  SessionRecord one;
  Row row(database_.sql());
  row.get("id", one.id)
      .get("patient_id", one.patient_id)
      .get("coalesce(uuid, '')", one.uuid)
      .get("resumes_id", one.resumes_id)
      .get("started_utc", one.started_utc)
      .get("ended_utc", one.ended_utc)
      .get("hand", one.hand, read_hand)
      .get("device_uri", one.device_uri)
      .get("device_description", one.device_description)
      .get("calibration", one.calibration)
      .get("simulated", one.simulated)
      .get("recorded", one.recorded)
      .get("provenance", one.provenance)
      .get("protocol_name", one.protocol_name)
      .get("protocol_text", one.protocol_text)
      .get("rate_Hz", one.rate_Hz)
      .get("device_delay_s", one.device_delay_s)
      .get("software_version", one.software_version)
      .get("cpu_features", one.cpu_features)
      .get("seed", one.seed, read_seed)
      .get("operator_name", one.operator_name)
      .get("realtime", one.realtime)
      .get("allowed", one.allowed);
  if (database_.format() >= kAnswersSinceFormat)
    row.get(display_delay_query("sessions.id"), one.display_delay_s, display_delay_from);
  row.select("FROM sessions " + where);
  while (row.fetch()) all.push_back(one);
  for (SessionRecord& session : all) {
    session.sensors = sensors_of(session.id);
    session.references = references_of("session", session.id);
  }
  return all;
}

Result<std::vector<SessionRecord>> SqliteStore::sessions(RowId patient) {
  std::vector<SessionRecord> all;
  const auto done = database_.guard("reading sessions"_text, [&] {
    // By time: those of another station may have been added later.
    all = read_sessions("WHERE patient_id = " + std::to_string(patient) +
                        " ORDER BY started_utc, id");
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<SessionRecord>> SqliteStore::recent_sessions(int most) {
  std::vector<SessionRecord> all;
  const auto done = database_.guard("reading the newest sessions"_text, [&] {
    all = read_sessions("ORDER BY started_utc DESC, id DESC LIMIT " +
                        std::to_string(std::max(most, 0)));
  });
  if (!done) return done.error();
  return all;
}

std::vector<SignalGroup> SqliteStore::groups_of(RowId trial) {
  std::vector<SignalGroup> groups;
  SignalGroup group;
  Row row(database_.sql());
  row.get("name", group.name).get("column_names", group.columns, lines_of);
  row.select("FROM signal_groups WHERE trial_id = :trial ORDER BY position", {trial});
  while (row.fetch()) groups.push_back(group);
  return groups;
}

void SqliteStore::add_preparations_of(RowId session, std::vector<TrialRecord>& trials) {
  const auto all =
      read_preparations("WHERE session_id = " + std::to_string(session) + " ORDER BY id");
  for (TrialRecord& trial : trials) {
    RowId id = 0;
    Row row(database_.sql());
    row.get("preparation_id", id);
    row.select("FROM trial_preparations WHERE trial_id = :trial ORDER BY preparation_id",
               {trial.id});
    while (row.fetch()) trial.preparations.push_back(id);
    for (auto used = all.begin(); used != all.end(); ++used) {
      if (!std::ranges::binary_search(trial.preparations, used->id)) continue;
      const auto next = std::find_if(used + 1, all.end(), [&](const PreparationRecord& later) {
        return later.kind == used->kind;
      });
      if (next == all.end()) continue;
      for (const auto& [name, value] : next->references)
        if (name.starts_with("drift")) trial.drift[name] = value;
      trial.drifted = trial.drifted || next->drifted;
    }
  }
}

Result<std::vector<TrialRecord>> SqliteStore::trials(RowId session) {
  std::vector<TrialRecord> all;
  const auto done = database_.guard("reading trials"_text, [&] {
    TrialRecord one;
    std::optional<int> step;
    std::optional<int> step_task;
    Row row(database_.sql());
    row.get("id", one.id)
        .get("session_id", one.session_id)
        .get("coalesce(uuid, '')", one.uuid)
        .get("number", one.number)
        .get("step", step)
        .get("step_task", step_task)
        .get("task_name", one.task_name)
        .get("task_version", one.task_version)
        .get("task_text", one.task_text)
        .get("scene_text", one.scene_text)
        .get("seed", one.seed, read_seed)
        .get("practice", one.practice)
        .get("helped", one.helped)
        .get("session_time_s", one.session_time_s)
        .get("status", one.status, read_status)
        .get(
            "coalesce(sample_count, (SELECT coalesce(sum(row_count), 0) FROM signal_blocks "
            "WHERE trial_id = trials.id AND position = 0))",
            one.samples)
        .get("dropped_count", one.dropped)
        .get("worst_lateness_s", one.worst_lateness_s)
        .get("worst_compute_s", one.worst_compute_s)
        .get("display_age_s", one.display_age_s)
        .get("viewing_distance_m", one.viewing_distance_m)
        .get("health_json", one.health_json)
        .get("timing_json", one.timing_json)
        .get("lower(hex(coalesce(signals_blake2b, '')))", one.signals_hash);
    row.select("FROM trials WHERE session_id = :session ORDER BY number", {session});
    while (row.fetch()) {
      one.place = step && step_task ? std::optional(TrialPlace{*step, *step_task}) : std::nullopt;
      all.push_back(one);
    }
    for (TrialRecord& trial : all) {
      trial.groups = groups_of(trial.id);
      trial.references = references_of("trial", trial.id);
    }
    add_preparations_of(session, all);
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<MeasurePoint>> SqliteStore::progress(RowId patient) {
  // The few trials in their order, then their many measures as they lie: nothing large is sorted.
  std::vector<MeasurePoint> trials;
  std::unordered_map<RowId, std::vector<Measure>> measures;
  std::size_t count = 0;
  const auto done = database_.guard("reading progress"_text, [&] {
    MeasurePoint one;
    Row row(database_.sql());
    row.get("s.id", one.session_id)
        .get("t.id", one.trial_id)
        .get("t.number", one.trial_number)
        .get("s.started_utc", one.started_utc)
        .get("s.hand", one.hand, read_hand)
        .get("t.practice", one.practice)
        .get("t.helped", one.helped)
        .get("s.simulated", one.simulated)
        .get("t.task_name", one.task_name)
        .get("t.task_version", one.task_version);
    row.select(
        "FROM sessions s JOIN trials t ON t.session_id = s.id WHERE s.patient_id = :patient "
        "AND t.status = 'completed' ORDER BY s.started_utc, s.id, t.number",
        {patient});
    while (row.fetch()) trials.push_back(one);

    RowId trial = 0;
    Measure measure;
    Row all(database_.sql());
    all.get("m.trial_id", trial);
    get_measure(all, measure, "m.");
    all.select(
        "FROM sessions s CROSS JOIN trials t ON t.session_id = s.id "
        "CROSS JOIN measures m ON m.trial_id = t.id "
        "WHERE s.patient_id = :patient AND t.status = 'completed'",
        {patient});
    for (; all.fetch(); ++count) measures[trial].push_back(measure);
  });
  if (!done) return done.error();
  std::vector<MeasurePoint> points;
  points.reserve(count);
  for (const MeasurePoint& trial : trials) {
    auto& of_trial = measures[trial.trial_id];
    keep_newest(of_trial);
    for (Measure& measure : of_trial) {
      points.push_back(trial);
      points.back().measure = std::move(measure);
    }
  }
  return points;
}

}  // namespace isograsp::storage
