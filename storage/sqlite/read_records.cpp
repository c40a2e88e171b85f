// SPDX-License-Identifier: GPL-3.0-or-later
// Reading patients, sessions, trials and their progress. Rows come in the order in which they were
// made.
#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include <soci/soci.h>

#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

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

/// A column that may be NULL.
struct Nullable {
  double value = 0.0;
  soci::indicator present = soci::i_null;
  [[nodiscard]] std::optional<double> get() const {
    return present == soci::i_ok ? std::optional(value) : std::nullopt;
  }
};

std::uint64_t read_seed(const std::string& text) {
  std::uint64_t seed = 0;
  std::from_chars(text.data(), text.data() + text.size(), seed);
  return seed;
}

}  // namespace

std::string serials_text(const std::array<std::string, kFingerCount>& serials) {
  if (serials == std::array<std::string, kFingerCount>{}) return "";
  return serials[0] + "\n" + serials[1] + "\n" + serials[2];
}

std::string SqliteStore::since(int format, const char* expression, const char* instead) const {
  return database_.format() >= format ? expression : instead;
}

Result<std::vector<PatientRecord>> SqliteStore::patients() {
  std::vector<PatientRecord> all;
  const auto done = database_.guard("reading patients", [&] {
    PatientRecord one;
    soci::statement select =
        (database_.sql().prepare << "SELECT id, code, created_utc, " + since(6, "uuid", "''") +
                                        " FROM patients ORDER BY id",
         soci::into(one.id), soci::into(one.code), soci::into(one.created_utc),
         soci::into(one.uuid));
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
    database_.sql() << "SELECT id, code, created_utc, " + since(6, "uuid", "''") +
                           " FROM patients WHERE code = :code",
        soci::use(code), soci::into(one.id), soci::into(one.code), soci::into(one.created_utc),
        soci::into(one.uuid);
    if (database_.sql().got_data()) found = one;
  });
  if (!done) return done.error();
  return found;
}

std::vector<SessionRecord> SqliteStore::read_sessions(const std::string& where) {
  std::vector<SessionRecord> all;
  SessionRecord one;
  std::string hand;
  std::string seed;
  std::string serials;
  std::string display;
  Nullable ceiling;
  int simulated = 0;
  int recorded = 0;
  soci::statement select =
      (database_.sql().prepare
           << "SELECT id, patient_id, started_utc, ended_utc, hand, device_uri, "
              "device_description, simulated, recorded, provenance, protocol_name, "
              "protocol_text, rate_Hz, device_delay_s, software_version, cpu_features, seed, " +
                  since(2, "device_serials, operator_name, realtime", "'', '', ''") + ", " +
                  since(3, "coalesce(resumes_id, 0), allowed, ceiling_N", "0, '', NULL") + ", " +
                  since(6, "calibration, uuid", "'', ''") + ", " +
                  since(4, display_delay_query("sessions.id").c_str(), "''") + " FROM sessions " +
                  where,
       soci::into(one.id), soci::into(one.patient_id), soci::into(one.started_utc),
       soci::into(one.ended_utc), soci::into(hand), soci::into(one.device_uri),
       soci::into(one.device_description), soci::into(simulated), soci::into(recorded),
       soci::into(one.provenance), soci::into(one.protocol_name), soci::into(one.protocol_text),
       soci::into(one.rate_Hz), soci::into(one.device_delay_s), soci::into(one.software_version),
       soci::into(one.cpu_features), soci::into(seed), soci::into(serials),
       soci::into(one.operator_name), soci::into(one.realtime), soci::into(one.resumes_id),
       soci::into(one.allowed), soci::into(ceiling.value, ceiling.present),
       soci::into(one.calibration), soci::into(one.uuid), soci::into(display));
  select.execute();
  while (select.fetch()) {
    one.display_delay_s = display_delay_from(display);
    one.ceiling_N = ceiling.get();
    one.hand = read_hand(hand);
    one.simulated = simulated != 0;
    one.recorded = recorded != 0;
    one.seed = read_seed(seed);
    one.serial_numbers = {};
    const auto lines = split_lines(serials);
    std::copy_n(lines.begin(), std::min(lines.size(), kFingerCount), one.serial_numbers.begin());
    all.push_back(one);
  }
  return all;
}

Result<std::vector<SessionRecord>> SqliteStore::sessions(RowId patient) {
  std::vector<SessionRecord> all;
  const auto done = database_.guard("reading sessions", [&] {
    // By time: those of another station may have been added later.
    all = read_sessions("WHERE patient_id = " + std::to_string(patient) +
                        " ORDER BY started_utc, id");
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<SessionRecord>> SqliteStore::recent_sessions(int most) {
  std::vector<SessionRecord> all;
  const auto done = database_.guard("reading the newest sessions", [&] {
    all = read_sessions("ORDER BY started_utc DESC, id DESC LIMIT " +
                        std::to_string(std::max(most, 0)));
  });
  if (!done) return done.error();
  return all;
}

std::vector<SignalGroup> SqliteStore::groups_of(RowId trial) {
  std::vector<SignalGroup> groups;
  SignalGroup group;
  std::string names;
  soci::statement select =
      (database_.sql().prepare << "SELECT name, column_names FROM signal_groups "
                                  "WHERE trial_id = :trial ORDER BY position",
       soci::use(trial), soci::into(group.name), soci::into(names));
  select.execute();
  while (select.fetch()) {
    group.columns = split_lines(names);
    groups.push_back(group);
  }
  return groups;
}

Result<std::vector<TrialRecord>> SqliteStore::trials(RowId session) {
  std::vector<TrialRecord> all;
  const auto done = database_.guard("reading trials", [&] {
    TrialRecord one;
    std::string status;
    int practice = 0;
    int drifted = 0;
    std::array<Nullable, kFingerCount> threshold;
    Nullable drift;
    std::string seed;
    TrialPlace place;
    int helped = 0;
    Nullable age;
    Nullable gain;
    Nullable distance;
    soci::statement select =
        (database_.sql().prepare
             << "SELECT id, session_id, number, task_name, task_version, task_text, scene_text, "
                "practice, session_time_s, status, maximum_force_N, resting_force_N, "
                "coalesce(zero_id, 0), coalesce(sample_count, (SELECT coalesce(sum(row_count), 0) "
                "FROM signal_blocks WHERE trial_id = trials.id AND position = 0)), dropped_count, "
                "worst_lateness_s, worst_compute_s, health_json, " +
                    since(2,
                          "timing_json, thumb_threshold_N, index_threshold_N, "
                          "middle_threshold_N, zero_drift_N, zero_drifted",
                          "'', NULL, NULL, NULL, NULL, 0") +
                    ", " +
                    since(3, "seed, coalesce(step, -1), coalesce(step_task, -1), helped",
                          "'', -1, -1, 0") +
                    ", " +
                    since(4, "display_age_s, visual_gain_deg_per_N, viewing_distance_m",
                          "NULL, NULL, NULL") +
                    ", " + since(6, "uuid, lower(hex(coalesce(signals_blake2b, '')))", "'', ''") +
                    " FROM trials WHERE session_id = :session ORDER BY number",
         soci::use(session), soci::into(one.id), soci::into(one.session_id), soci::into(one.number),
         soci::into(one.task_name), soci::into(one.task_version), soci::into(one.task_text),
         soci::into(one.scene_text), soci::into(practice), soci::into(one.session_time_s),
         soci::into(status), soci::into(one.maximum_force_N), soci::into(one.resting_force_N),
         soci::into(one.zero_id), soci::into(one.samples), soci::into(one.dropped),
         soci::into(one.worst_lateness_s), soci::into(one.worst_compute_s),
         soci::into(one.health_json), soci::into(one.timing_json),
         soci::into(threshold[0].value, threshold[0].present),
         soci::into(threshold[1].value, threshold[1].present),
         soci::into(threshold[2].value, threshold[2].present),
         soci::into(drift.value, drift.present), soci::into(drifted), soci::into(seed),
         soci::into(place.step), soci::into(place.task), soci::into(helped),
         soci::into(age.value, age.present), soci::into(gain.value, gain.present),
         soci::into(distance.value, distance.present), soci::into(one.uuid),
         soci::into(one.signals_hash));
    select.execute();
    while (select.fetch()) {
      one.display_age_s = age.get();
      one.visual_gain_deg_per_N = gain.get();
      one.viewing_distance_m = distance.get();
      one.seed = read_seed(seed);
      one.place = place.step >= 0 ? std::optional(place) : std::nullopt;
      one.helped = helped != 0;
      for (std::size_t f = 0; f < kFingerCount; ++f) one.threshold_N[f] = threshold[f].get();
      one.zero_drift_N = drift.get();
      one.zero_drifted = drifted != 0;
      one.practice = practice != 0;
      one.status = read_status(status);
      all.push_back(one);
    }
    for (TrialRecord& trial : all) trial.groups = groups_of(trial.id);
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<MeasurePoint>> SqliteStore::progress(RowId patient) {
  // The few trials in their order, then their many measures as they lie: nothing large is sorted.
  std::vector<MeasurePoint> trials;
  std::unordered_map<RowId, std::vector<Measure>> measures;
  std::size_t count = 0;
  const auto done =
      database_.guard("reading progress", [&] {
        MeasurePoint one;
        std::string hand;
        int practice = 0;
        int helped = 0;
        int simulated = 0;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT s.id, t.id, t.number, s.started_utc, s.hand, t.practice, s.simulated, "
                    "t.task_name, t.task_version, " +
                        since(3, "t.helped", "0") +
                        " FROM sessions s JOIN trials t ON t.session_id = s.id "
                        "WHERE s.patient_id = :patient AND t.status = 'completed' "
                        "ORDER BY s.started_utc, s.id, t.number",
             soci::use(patient), soci::into(one.session_id), soci::into(one.trial_id),
             soci::into(one.trial_number), soci::into(one.started_utc), soci::into(hand),
             soci::into(practice), soci::into(simulated), soci::into(one.task_name),
             soci::into(one.task_version), soci::into(helped));
        select.execute();
        while (select.fetch()) {
          one.helped = helped != 0;
          one.hand = read_hand(hand);
          one.practice = practice != 0;
          one.simulated = simulated != 0;
          trials.push_back(one);
        }

        RowId trial = 0;
        Measure measure;
        double value = 0.0;
        soci::indicator present = soci::i_ok;
        soci::statement all =
            (database_.sql().prepare
                 << "SELECT m.trial_id, m.name, m.channel, m.value, m.unit, m.version, "
                    "m.sample_count, m.excluded_count, m.reason FROM sessions s "
                    "CROSS JOIN trials t ON t.session_id = s.id "
                    "CROSS JOIN measures m ON m.trial_id = t.id "
                    "WHERE s.patient_id = :patient AND t.status = 'completed'",
             soci::use(patient), soci::into(trial), soci::into(measure.name),
             soci::into(measure.channel), soci::into(value, present), soci::into(measure.unit),
             soci::into(measure.version), soci::into(measure.samples), soci::into(measure.excluded),
             soci::into(measure.reason));
        all.execute();
        for (; all.fetch(); ++count) {
          measure.value = present == soci::i_ok ? std::optional(value) : std::nullopt;
          measures[trial].push_back(measure);
        }
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
