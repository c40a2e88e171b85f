// SPDX-License-Identifier: GPL-3.0-or-later
// Reading what belongs to a session or a trial: measures, events, zeros, resting forces, ratings.
// Rows come in the order in which they were made.
#include <array>

#include <soci/soci.h>

#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

std::optional<double> optional(double value, soci::indicator present) {
  return present == soci::i_ok ? std::optional(value) : std::nullopt;
}

std::array<Vec6, kFingerCount> unpack(soci::blob& blob) {
  std::array<Vec6, kFingerCount> wrenches;
  for (std::size_t f = 0; f < kFingerCount; ++f)
    blob.read(f * 6 * sizeof(double), reinterpret_cast<char*>(wrenches[f].data()),
              6 * sizeof(double));
  return wrenches;
}

}  // namespace

Result<std::vector<Measure>> SqliteStore::measures(RowId trial) {
  auto all = measures_of_all_versions(trial);
  if (all) keep_newest(*all);
  return all;
}

Result<std::vector<Measure>> SqliteStore::measures_of_all_versions(RowId trial) {
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

std::vector<InstrumentZeroRecord> SqliteStore::read_zeros(const std::string& where) {
  std::vector<InstrumentZeroRecord> all;
  InstrumentZeroRecord one;
  soci::blob mean(database_.sql());
  soci::blob sd(database_.sql());
  double change = 0.0;
  soci::indicator change_present = soci::i_null;
  double drift = 0.0;
  soci::indicator drift_present = soci::i_null;
  int confirmed = 0;
  soci::statement select =
      (database_.sql().prepare
           << "SELECT z.id, z.session_id, z.session_time_s, z.mean_N_Nm, z.sd_N_Nm, " +
                  since(2,
                        "z.recorded_utc, z.operator_name, z.change_N, z.change_confirmed, "
                        "z.drift_N",
                        "'', '', NULL, 0, NULL") +
                  " FROM instrument_zeros z JOIN sessions s ON s.id = z.session_id " + where,
       soci::into(one.id), soci::into(one.session_id), soci::into(one.session_time_s),
       soci::into(mean), soci::into(sd), soci::into(one.recorded_utc),
       soci::into(one.operator_name), soci::into(change, change_present), soci::into(confirmed),
       soci::into(drift, drift_present));
  select.execute();
  while (select.fetch()) {
    one.mean = unpack(mean);
    one.sd = unpack(sd);
    one.change_N = optional(change, change_present);
    one.change_confirmed = confirmed != 0;
    one.drift_N = optional(drift, drift_present);
    all.push_back(one);
  }
  return all;
}

Result<std::vector<InstrumentZeroRecord>> SqliteStore::zeros(RowId session) {
  std::vector<InstrumentZeroRecord> all;
  const auto done = database_.guard("reading instrument zeros", [&] {
    all = read_zeros("WHERE z.session_id = " + std::to_string(session) + " ORDER BY z.id");
  });
  if (!done) return done.error();
  return all;
}

Result<std::optional<InstrumentZeroRecord>> SqliteStore::last_zero(const SessionRecord& session) {
  const auto& told = session.serial_numbers;
  const bool all_told =
      std::none_of(told.begin(), told.end(), [](const std::string& s) { return s.empty(); });
  const std::string serials = serials_text(told);
  const int simulated = session.simulated ? 1 : 0;
  std::optional<InstrumentZeroRecord> found;
  const auto done = database_.guard("reading the last instrument zero", [&] {
    soci::session& sql = database_.sql();
    RowId id = 0;
    const std::string same_place = all_told ? "" : " AND s.device_uri = :uri";
    soci::statement select(sql);
    select.exchange(soci::use(simulated));
    select.exchange(soci::use(serials));
    if (!all_told) select.exchange(soci::use(session.device_uri));
    select.exchange(soci::into(id));
    select.alloc();
    select.prepare(
        "SELECT coalesce(max(z.id), 0) FROM instrument_zeros z JOIN sessions s "
        "ON s.id = z.session_id WHERE s.simulated = :simulated AND s.recorded = 0 AND " +
        since(2, "s.device_serials", "''") + " = :serials" + same_place);
    select.define_and_bind();
    select.execute(true);
    if (id == 0) return;
    found = read_zeros("WHERE z.id = " + std::to_string(id)).front();
  });
  if (!done) return done.error();
  return found;
}

Result<std::vector<RestingForceRecord>> SqliteStore::resting_forces(RowId session) {
  std::vector<RestingForceRecord> all;
  if (database_.format() < 2) return all;
  const auto done =
      database_.guard("reading resting forces", [&] {
        RestingForceRecord one;
        soci::blob mean(database_.sql());
        soci::blob sd(database_.sql());
        double since = 0.0;
        soci::indicator since_present = soci::i_null;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT id, session_id, trial_id, session_time_s, recorded_utc, operator_name, "
                    "duration_s, since_strapping_s, sample_count, mean_N_Nm, sd_N_Nm "
                    "FROM resting_forces WHERE session_id = :session ORDER BY id",
             soci::use(session), soci::into(one.id), soci::into(one.session_id),
             soci::into(one.trial_id), soci::into(one.session_time_s), soci::into(one.recorded_utc),
             soci::into(one.operator_name), soci::into(one.duration_s),
             soci::into(since, since_present), soci::into(one.samples), soci::into(mean),
             soci::into(sd));
        select.execute();
        while (select.fetch()) {
          one.since_strapping_s = optional(since, since_present);
          one.mean = unpack(mean);
          one.sd = unpack(sd);
          all.push_back(one);
        }
      });
  if (!done) return done.error();
  return all;
}

Result<std::vector<RatingRecord>> SqliteStore::ratings(RowId session) {
  std::vector<RatingRecord> all;
  if (database_.format() < 3) return all;
  const auto done =
      database_.guard("reading ratings", [&] {
        RatingRecord one;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT id, session_id, coalesce(trial_id, 0), session_time_s, recorded_utc, "
                    "effort, pain FROM ratings WHERE session_id = :session ORDER BY id",
             soci::use(session), soci::into(one.id), soci::into(one.session_id),
             soci::into(one.trial_id), soci::into(one.session_time_s), soci::into(one.recorded_utc),
             soci::into(one.effort), soci::into(one.pain));
        select.execute();
        while (select.fetch()) all.push_back(one);
      });
  if (!done) return done.error();
  return all;
}

}  // namespace isograsp::storage
