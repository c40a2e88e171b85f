// SPDX-License-Identifier: GPL-3.0-or-later
// Reading what belongs to a session or a trial: measures, events, preparations, ratings.
// Rows come in the order in which they were made.
#include <algorithm>

#include <soci/soci.h>

#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

/// Empty if no sensor told its own.
std::string serials_text(const std::vector<SensorRecord>& sensors) {
  std::vector<std::string> serials;
  bool told = false;
  for (const SensorRecord& sensor : sensors) {
    serials.push_back(sensor.serial_number);
    told = told || !sensor.serial_number.empty();
  }
  return told ? as_lines(serials) : "";
}

}  // namespace

Result<std::vector<Measure>> SqliteStore::measures(RowId trial) {
  auto all = measures_of_all_versions(trial);
  if (all) keep_newest(*all);
  return all;
}

Result<std::vector<Measure>> SqliteStore::measures_of_all_versions(RowId trial) {
  std::vector<Measure> all;
  const auto done = database_.guard("reading measures"_text, [&] {
    Measure one;
    Row row(database_.sql());
    get_measure(row, one);
    row.select("FROM measures WHERE trial_id = :trial ORDER BY id", {trial});
    while (row.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<std::vector<EventRecord>> SqliteStore::events(RowId session) {
  std::vector<EventRecord> all;
  const auto done = database_.guard("reading events"_text, [&] {
    EventRecord one;
    Row row(database_.sql());
    row.get("trial_id", one.trial_id)
        .get("session_time_s", one.session_time_s)
        .get("kind", one.kind)
        .get("text", one.text);
    row.select("FROM events WHERE session_id = :session ORDER BY id", {session});
    while (row.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

std::vector<PreparationRecord> SqliteStore::read_preparations(const std::string& where) {
  std::vector<PreparationRecord> all;
  PreparationRecord one;
  Row row(database_.sql());
  row.get("id", one.id)
      .get("session_id", one.session_id)
      .get("kind", one.kind)
      .get("trial_id", one.trial_id)
      .get("session_time_s", one.session_time_s)
      .get("recorded_utc", one.recorded_utc)
      .get("operator_name", one.operator_name)
      .get("change_confirmed", one.change_confirmed)
      .get("drifted", one.drifted)
      .get("sample_count", one.samples)
      .get("column_names", one.columns, lines_of)
      .get("mean_float64", one.mean)
      .get("sd_float64", one.sd);
  row.select("FROM preparations " + where);
  while (row.fetch()) all.push_back(one);
  for (PreparationRecord& preparation : all)
    preparation.references = references_of("preparation", preparation.id);
  return all;
}

Result<std::vector<PreparationRecord>> SqliteStore::preparations(RowId session) {
  std::vector<PreparationRecord> all;
  const auto done = database_.guard("reading preparations"_text, [&] {
    all = read_preparations("WHERE session_id = " + std::to_string(session) + " ORDER BY id");
  });
  if (!done) return done.error();
  return all;
}

Result<std::optional<PreparationRecord>> SqliteStore::last_preparation(const SessionRecord& session,
                                                                       const std::string& kind) {
  const auto& sensors = session.sensors;
  const bool all_told = !sensors.empty() && std::ranges::none_of(sensors, [](const auto& sensor) {
    return sensor.serial_number.empty();
  });
  const std::string serials = serials_text(sensors);
  const int simulated = session.simulated ? 1 : 0;
  const int anywhere = all_told ? 1 : 0;
  std::optional<PreparationRecord> found;
  const auto done = database_.guard("reading the last preparation"_text, [&] {
    RowId id = 0;
    Row row(database_.sql());
    row.get("coalesce(max(p.id), 0)", id);
    row.select(
        "FROM preparations p JOIN sessions s ON s.id = p.session_id WHERE p.kind = :kind "
        "AND s.simulated = :simulated AND s.recorded = 0 "
        "AND coalesce((SELECT CASE WHEN max(serial_number) = '' THEN '' "
        "ELSE group_concat(serial_number, char(10)) END FROM (SELECT serial_number "
        "FROM session_sensors WHERE session_id = s.id ORDER BY position)), '') = :serials "
        "AND (:anywhere = 1 OR s.device_uri = :uri)",
        {kind, simulated, serials, anywhere, session.device_uri});
    if (!row.fetch() || id == 0) return;
    found = read_preparations("WHERE id = " + std::to_string(id)).front();
  });
  if (!done) return done.error();
  return found;
}

Result<std::vector<RatingRecord>> SqliteStore::ratings(RowId session) {
  std::vector<RatingRecord> all;
  if (database_.format() < 3) return all;
  const auto done = database_.guard("reading ratings"_text, [&] {
    RatingRecord one;
    Row row(database_.sql());
    row.get("id", one.id)
        .get("session_id", one.session_id)
        .get("trial_id", one.trial_id)
        .get("session_time_s", one.session_time_s)
        .get("recorded_utc", one.recorded_utc)
        .get("effort", one.effort)
        .get("pain", one.pain)
        .get(
            "(SELECT CAST(e.text AS INTEGER) FROM events e WHERE e.session_id = "
            "ratings.session_id AND e.session_time_s = ratings.session_time_s AND e.kind = '" +
                std::string(kShoulderPainEvent) + "')",
            one.shoulder_pain);
    row.select("FROM ratings WHERE session_id = :session ORDER BY id", {session});
    while (row.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

}  // namespace isograsp::storage
