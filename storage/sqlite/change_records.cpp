// SPDX-License-Identifier: GPL-3.0-or-later
// What verdicts of change are made from: primary measures, times judged stable, values of stable
// people.
#include <ctime>

#include <soci/soci.h>

#include "core/time.hpp"
#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

constexpr int kChangeSinceFormat = 5;
constexpr int kSinceSexAndAge = 7;

std::string or_now(const std::string& utc) {
  return utc.empty() ? utc_text(std::time(nullptr)) : utc;
}

}  // namespace

Result<std::vector<PrimaryMeasure>> SqliteStore::primary_measures(RowId patient) {
  std::vector<PrimaryMeasure> all;
  if (database_.format() < kChangeSinceFormat) return all;
  const auto done =
      database_.guard("reading primary measures"_text, [&] {
        PrimaryMeasure one;
        std::string hand;
        soci::statement select =
            (database_.sql().prepare
                 << "SELECT id, task_name, hand, measure, channel, chosen_utc, chosen_by "
                    "FROM primary_measures WHERE patient_id = :patient ORDER BY chosen_utc, id",
             soci::use(patient), soci::into(one.id), soci::into(one.task_name), soci::into(hand),
             soci::into(one.measure), soci::into(one.channel), soci::into(one.chosen_utc),
             soci::into(one.chosen_by));
        select.execute();
        while (select.fetch()) {
          one.hand = hand_from_name(hand);
          all.push_back(one);
        }
      });
  if (!done) return done.error();
  return all;
}

Result<RowId> SqliteStore::add_primary_measure(RowId patient, const PrimaryMeasure& primary) {
  if (const auto good = check_primary_measure(primary); !good) return good.error();
  const std::string hand(name_of(primary.hand));
  const std::string chosen_utc = or_now(primary.chosen_utc);
  RowId id = 0;
  const auto done = database_.transact("storing a primary measure"_text, [&] {
    require("patients", "patient"_text, patient);
    soci::session& sql = database_.sql();
    int there = 0;
    int same = 0;
    sql << "SELECT count(*), coalesce(sum(task_name = :task AND hand = :hand AND "
           "measure = :measure AND channel = :channel), 0) FROM primary_measures "
           "WHERE patient_id = :patient",
        soci::use(primary.task_name), soci::use(hand), soci::use(primary.measure),
        soci::use(primary.channel), soci::use(patient), soci::into(there), soci::into(same);
    if (same > 0)
      throw Refusal{
          refused("%1 of %2 is a primary measure"_text(primary.measure, primary.task_name),
                  "choose another one"_text)
              .at(path())};
    if (there >= kMostPrimaryMeasures)
      throw Refusal{refused("there are %1 primary measures already"_text(there),
                            "remove one of them first"_text)
                        .at(path())};
    sql << "INSERT INTO primary_measures (patient_id, task_name, hand, measure, channel, "
           "chosen_utc, chosen_by) VALUES (:patient, :task, :hand, :measure, :channel, :utc, :by)",
        soci::use(patient), soci::use(primary.task_name), soci::use(hand),
        soci::use(primary.measure), soci::use(primary.channel), soci::use(chosen_utc),
        soci::use(primary.chosen_by);
    id = last_id(sql, "primary_measures");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::remove_primary_measure(RowId id) {
  return database_.transact("removing a primary measure"_text, [&] {
    require("primary_measures", "primary measure"_text, id);
    database_.sql() << "DELETE FROM primary_measures WHERE id = :id", soci::use(id);
  });
}

Result<std::vector<StablePeriod>> SqliteStore::stable_periods(RowId patient) {
  std::vector<StablePeriod> all;
  if (database_.format() < kChangeSinceFormat) return all;
  const auto done = database_.guard("reading stable times"_text, [&] {
    StablePeriod one;
    soci::statement select =
        (database_.sql().prepare << "SELECT id, from_date, until_date, judged_utc, judged_by, text "
                                    "FROM stable_periods WHERE patient_id = :patient "
                                    "ORDER BY from_date, id",
         soci::use(patient), soci::into(one.id), soci::into(one.from_date),
         soci::into(one.until_date), soci::into(one.judged_utc), soci::into(one.judged_by),
         soci::into(one.text));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<RowId> SqliteStore::add_stable_period(RowId patient, const StablePeriod& period) {
  if (const auto good = check_stable_period(period); !good) return good.error();
  const std::string judged_utc = or_now(period.judged_utc);
  RowId id = 0;
  const auto done = database_.transact("storing a stable time"_text, [&] {
    require("patients", "patient"_text, patient);
    soci::session& sql = database_.sql();
    std::string from;
    std::string until;
    sql << "SELECT from_date, until_date FROM stable_periods WHERE patient_id = :patient "
           "AND from_date <= :until AND until_date >= :from LIMIT 1",
        soci::use(patient), soci::use(period.until_date), soci::use(period.from_date),
        soci::into(from), soci::into(until);
    if (sql.got_data())
      throw Refusal{refused("overlaps the stable time from %1 to %2"_text(from, until),
                            "remove that one first, or give other days"_text)
                        .at(path())};
    sql << "INSERT INTO stable_periods (patient_id, from_date, until_date, judged_utc, judged_by, "
           "text) VALUES (:patient, :from, :until, :utc, :by, :text)",
        soci::use(patient), soci::use(period.from_date), soci::use(period.until_date),
        soci::use(judged_utc), soci::use(period.judged_by), soci::use(period.text);
    id = last_id(sql, "stable_periods");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::remove_stable_period(RowId id) {
  return database_.transact("removing a stable time"_text, [&] {
    require("stable_periods", "stable time"_text, id);
    database_.sql() << "DELETE FROM stable_periods WHERE id = :id", soci::use(id);
  });
}

Result<std::vector<PooledValue>> SqliteStore::stable_values(const PoolQuery& query) {
  if (database_.format() < kChangeSinceFormat) return std::vector<PooledValue>();
  return pooled_values(query,
                       "(SELECT patient_id, id, from_date, until_date FROM stable_periods) p "
                       "CROSS JOIN sessions s ON s.patient_id = p.patient_id "
                       "AND substr(s.started_utc, 1, 10) BETWEEN p.from_date AND p.until_date ");
}

Result<std::vector<PooledValue>> SqliteStore::healthy_values(const PoolQuery& query) {
  if (database_.format() < kSinceSexAndAge) return std::vector<PooledValue>();
  return pooled_values(query,
                       "(SELECT patient_id, 0 AS id FROM patient_profiles "
                       "WHERE affected = 'none') p "
                       "CROSS JOIN sessions s ON s.patient_id = p.patient_id ");
}

Result<std::vector<PooledValue>> SqliteStore::pooled_values(const PoolQuery& query,
                                                            const std::string& people) {
  std::vector<PooledValue> all;
  const int simulated = query.simulated ? 1 : 0;
  const int recorded = query.recorded ? 1 : 0;
  const auto done = database_.guard("reading values of other people"_text, [&] {
    PooledValue one;
    Row row(database_.sql());
    row.get("p.patient_id", one.patient_id)
        .get("p.id", one.period_id)
        .get("s.id", one.session_id)
        .get("t.id", one.trial_id)
        .get("m.version", one.measure_version)
        .get("s.started_utc", one.started_utc)
        .get("s.hand", one.hand, hand_from_name)
        .get("coalesce(f.affected, '')", one.affected, side_from_name)
        .get("coalesce(f.dominant, '')", one.dominant, hand_from_name)
        .get("coalesce(f.sex, '')", one.sex, sex_from_name)
        .get("f.birth_year", one.birth_year)
        .get("s.rate_Hz", one.rate_Hz)
        .get("s.device_delay_s", one.device_delay_s)
        .get(display_delay_query("s.id"), one.display_delay_s, display_delay_from)
        .get("m.value", one.value);
    if (!query.scene_text)
      row.get("t.scene_text", one.scene_text)
          .get("s.calibration", one.calibration)
          .get("s.device_uri", one.device_uri);
    // CROSS JOIN: from the few people down to the trials, never through all measures.
    row.select(
        "FROM " + people +
            "LEFT JOIN patient_profiles f ON f.patient_id = p.patient_id "
            "CROSS JOIN trials t ON t.session_id = s.id "
            "CROSS JOIN measures m ON m.trial_id = t.id "
            "WHERE s.simulated = :simulated AND s.recorded = :recorded "
            "AND t.task_name = :task AND t.task_version = :task_version "
            "AND t.status = 'completed' AND t.practice = 0 AND t.helped = 0 "
            "AND t.task_text = :text AND (:any_scene = 1 OR t.scene_text = :scene) AND m.name = "
            ":measure "
            "AND m.channel = :channel AND m.unit = :unit AND m.version <= :version "
            "ORDER BY p.patient_id, s.started_utc, s.id, t.number",
        {std::int64_t{simulated}, std::int64_t{recorded}, query.task_name, query.task_version,
         query.task_text, std::int64_t{query.scene_text ? 0 : 1}, query.scene_text.value_or(""),
         query.measure, query.channel, query.unit, query.measure_version});
    while (row.fetch()) {
      // The same trial again: its result in another version.
      if (!all.empty() && all.back().trial_id == one.trial_id &&
          all.back().period_id == one.period_id &&
          all.back().measure_version != one.measure_version) {
        if (one.measure_version > all.back().measure_version) all.back() = one;
        continue;
      }
      all.push_back(one);
    }
    for (PooledValue& value : all) value.references = references_of("trial", value.trial_id);
  });
  if (!done) return done.error();
  return all;
}

}  // namespace isograsp::storage
