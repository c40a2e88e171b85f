// SPDX-License-Identifier: GPL-3.0-or-later
// Reading everything but signals. Rows come in the order in which they were made.
#include <array>
#include <charconv>
#include <cstring>

#include <soci/soci.h>

#include "storage/sqlite_store.hpp"

namespace isograsp {

namespace {

Hand read_hand(const std::string& name) {
  return hand_from_name(name).value_or(Hand::right);
}

TrialStatus read_status(const std::string& name) {
  for (const auto status : {TrialStatus::completed, TrialStatus::aborted, TrialStatus::interrupted})
    if (name == name_of(status)) return status;
  return TrialStatus::running;
}

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::array<Vec6, kFingerCount> unpack(soci::blob& blob) {
  std::array<Vec6, kFingerCount> wrenches;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    blob.read(f * 6 * sizeof(double), reinterpret_cast<char*>(wrenches[f].data()),
              6 * sizeof(double));
  return wrenches;
}

}  // namespace

Result<std::vector<PatientRecord>> SqliteStore::patients() {
  std::vector<PatientRecord> all;
  const auto done = database_.guard("reading patients", [&] {
    PatientRecord one;
    soci::statement select =
        (database_.sql().prepare << "SELECT id, code, created_utc FROM patients ORDER BY id",
         soci::into(one.id), soci::into(one.code), soci::into(one.created_utc));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<std::optional<PatientRecord>> SqliteStore::find_patient(const std::string& code) {
  std::optional<PatientRecord> found;
  const auto done = database_.guard("reading patients", [&] {
    PatientRecord one;
    database_.sql() << "SELECT id, code, created_utc FROM patients "
                       "WHERE code = :code",
        soci::use(code), soci::into(one.id), soci::into(one.code), soci::into(one.created_utc);
    if (database_.sql().got_data()) found = one;
  });
  if (!done) return done.error();
  return found;
}

Result<std::vector<SessionRecord>> SqliteStore::sessions(RowId patient) {
  std::vector<SessionRecord> all;
  const auto done =
      database_.guard("reading sessions", [&] {
        SessionRecord one;
        std::string hand;
        std::string seed;
        int simulated = 0;
        int recorded = 0;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT id, patient_id, started_utc, ended_utc, hand, device_uri, "
                    "device_description, simulated, recorded, provenance, protocol_name, "
                    "protocol_text, rate_Hz, device_delay_s, software_version, cpu_features, seed "
                    "FROM sessions WHERE patient_id = :patient ORDER BY id",
             soci::use(patient), soci::into(one.id), soci::into(one.patient_id),
             soci::into(one.started_utc), soci::into(one.ended_utc), soci::into(hand),
             soci::into(one.device_uri), soci::into(one.device_description), soci::into(simulated),
             soci::into(recorded), soci::into(one.provenance), soci::into(one.protocol_name),
             soci::into(one.protocol_text), soci::into(one.rate_Hz), soci::into(one.device_delay_s),
             soci::into(one.software_version), soci::into(one.cpu_features), soci::into(seed));
        select.execute();
        while (select.fetch()) {
          one.hand = read_hand(hand);
          one.simulated = simulated != 0;
          one.recorded = recorded != 0;
          one.seed = 0;
          std::from_chars(seed.data(), seed.data() + seed.size(), one.seed);
          all.push_back(one);
        }
      });
  if (!done) return done.error();
  return all;
}

void SqliteStore::read_groups(TrialRecord& trial) {
  SignalGroup group;
  std::string names;
  soci::statement select =
      (database_.sql().prepare << "SELECT name, column_names FROM signal_groups "
                                  "WHERE trial_id = :trial ORDER BY position",
       soci::use(trial.id), soci::into(group.name), soci::into(names));
  select.execute();
  while (select.fetch()) {
    group.columns = split_lines(names);
    trial.groups.push_back(group);
  }
}

Result<std::vector<TrialRecord>> SqliteStore::trials(RowId session) {
  std::vector<TrialRecord> all;
  const auto done = database_.guard("reading trials", [&] {
    TrialRecord one;
    std::string status;
    int practice = 0;
    soci::statement select =
        (database_.sql().prepare
             << "SELECT id, session_id, number, task_name, task_version, task_text, scene_text, "
                "practice, session_time_s, status, maximum_force_N, resting_force_N, "
                "coalesce(zero_id, 0), coalesce(sample_count, (SELECT coalesce(sum(row_count), 0) "
                "FROM signal_blocks WHERE trial_id = trials.id AND position = 0)), dropped_count, "
                "worst_lateness_s, worst_compute_s, health_json "
                "FROM trials WHERE session_id = :session ORDER BY number",
         soci::use(session), soci::into(one.id), soci::into(one.session_id), soci::into(one.number),
         soci::into(one.task_name), soci::into(one.task_version), soci::into(one.task_text),
         soci::into(one.scene_text), soci::into(practice), soci::into(one.session_time_s),
         soci::into(status), soci::into(one.maximum_force_N), soci::into(one.resting_force_N),
         soci::into(one.zero_id), soci::into(one.samples), soci::into(one.dropped),
         soci::into(one.worst_lateness_s), soci::into(one.worst_compute_s),
         soci::into(one.health_json));
    select.execute();
    while (select.fetch()) {
      one.practice = practice != 0;
      one.status = read_status(status);
      all.push_back(one);
    }
    for (TrialRecord& trial : all) read_groups(trial);
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<Measure>> SqliteStore::measures(RowId trial) {
  std::vector<Measure> all;
  const auto done = database_.guard("reading measures", [&] {
    Measure one;
    double value = 0.0;
    soci::indicator present = soci::i_ok;
    soci::statement select =
        (database_.sql().prepare
             << "SELECT name, channel, value, unit, version, sample_count, excluded_count, reason "
                "FROM measures WHERE trial_id = :trial ORDER BY id",
         soci::use(trial), soci::into(one.name), soci::into(one.channel),
         soci::into(value, present), soci::into(one.unit), soci::into(one.version),
         soci::into(one.samples), soci::into(one.excluded), soci::into(one.reason));
    select.execute();
    while (select.fetch()) {
      one.value = present == soci::i_ok ? std::optional(value) : std::nullopt;
      all.push_back(one);
    }
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<EventRecord>> SqliteStore::events(RowId session) {
  std::vector<EventRecord> all;
  const auto done = database_.guard("reading events", [&] {
    EventRecord one;
    soci::statement select =
        (database_.sql().prepare << "SELECT coalesce(trial_id, 0), session_time_s, kind, text "
                                    "FROM events WHERE session_id = :session ORDER BY id",
         soci::use(session), soci::into(one.trial_id), soci::into(one.session_time_s),
         soci::into(one.kind), soci::into(one.text));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<InstrumentZeroRecord>> SqliteStore::zeros(RowId session) {
  std::vector<InstrumentZeroRecord> all;
  const auto done = database_.guard("reading instrument zeros", [&] {
    InstrumentZeroRecord one;
    soci::blob mean(database_.sql());
    soci::blob sd(database_.sql());
    soci::statement select =
        (database_.sql().prepare
             << "SELECT id, session_id, session_time_s, mean_N_Nm, sd_N_Nm FROM instrument_zeros "
                "WHERE session_id = :session ORDER BY id",
         soci::use(session), soci::into(one.id), soci::into(one.session_id),
         soci::into(one.session_time_s), soci::into(mean), soci::into(sd));
    select.execute();
    while (select.fetch()) {
      one.mean = unpack(mean);
      one.sd = unpack(sd);
      all.push_back(one);
    }
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<MeasurePoint>> SqliteStore::progress(RowId patient) {
  std::vector<MeasurePoint> all;
  const auto done =
      database_.guard("reading progress", [&] {
        MeasurePoint one;
        std::string hand;
        int practice = 0;
        int simulated = 0;
        double value = 0.0;
        soci::indicator present = soci::i_ok;
        Measure& measure = one.measure;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT s.id, t.id, t.number, s.started_utc, s.hand, t.practice, s.simulated, "
                    "t.task_name, t.task_version, m.name, m.channel, m.value, m.unit, m.version, "
                    "m.sample_count, m.excluded_count, m.reason "
                    "FROM sessions s JOIN trials t ON t.session_id = s.id "
                    "JOIN measures m ON m.trial_id = t.id "
                    "WHERE s.patient_id = :patient AND t.status = 'completed' "
                    "ORDER BY s.started_utc, s.id, t.number, m.id",
             soci::use(patient), soci::into(one.session_id), soci::into(one.trial_id),
             soci::into(one.trial_number), soci::into(one.started_utc), soci::into(hand),
             soci::into(practice), soci::into(simulated), soci::into(one.task_name),
             soci::into(one.task_version), soci::into(measure.name), soci::into(measure.channel),
             soci::into(value, present), soci::into(measure.unit), soci::into(measure.version),
             soci::into(measure.samples), soci::into(measure.excluded), soci::into(measure.reason));
        select.execute();
        while (select.fetch()) {
          one.hand = read_hand(hand);
          one.practice = practice != 0;
          one.simulated = simulated != 0;
          measure.value = present == soci::i_ok ? std::optional(value) : std::nullopt;
          all.push_back(one);
        }
      });
  if (!done) return done.error();
  return all;
}

}  // namespace isograsp
