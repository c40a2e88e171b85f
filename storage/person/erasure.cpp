// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/person/erasure.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <string_view>

#include <soci/soci.h>

#include "core/date.hpp"
#include "storage/access/audit_chain.hpp"
#include "storage/file/remains.hpp"
#include "storage/file/sweep.hpp"
#include "storage/person/person_rows.hpp"

namespace isograsp::storage {

namespace {

constexpr const char* kOfPatient = "patient_id = :id";
constexpr const char* kOfSession = "session_id IN (SELECT id FROM sessions WHERE patient_id = :id)";
constexpr const char* kOfTrial =
    "trial_id IN (SELECT t.id FROM trials t JOIN sessions s ON s.id = t.session_id "
    "WHERE s.patient_id = :id)";
constexpr const char* kOfPreparation =
    "preparation_id IN (SELECT r.id FROM preparations r JOIN sessions s ON s.id = r.session_id "
    "WHERE s.patient_id = :id)";

struct PersonalTable {
  const char* name;
  const char* rows;           ///< of a person
  const char* newest = "''";  ///< SQL: the day or time that a row speaks of or was made at
};
/// In an order in which nothing refers to what is gone. Tests compare it with the tables of the
/// database. What belongs to a session has its time within it.
constexpr std::array<PersonalTable, 25> kPersonal{{
    {"ratings", kOfSession},
    {"trial_preparations", kOfSession},
    {"preparation_references", kOfPreparation},
    {"preparations", kOfSession},
    {"events", kOfSession},
    {"measures", kOfTrial},
    {"signal_packs", kOfTrial},
    {"signal_blocks", kOfTrial},
    {"signal_groups", kOfTrial},
    {"trial_references", kOfTrial},
    {"trials", kOfSession},
    {"session_answers", kOfSession},
    {"session_references", kOfSession},
    {"session_sensors", kOfSession},
    {"sessions", kOfPatient, "max(started_utc, ended_utc)"},
    {"stable_periods", kOfPatient, "max(until_date, judged_utc)"},
    {"primary_measures", kOfPatient, "chosen_utc"},
    {"clinical_scores", kOfPatient, "on_date"},
    {"treatment_marks", kOfPatient, "on_date"},
    {"patient_profiles", kOfPatient},
    {"identities", kOfPatient, "changed_utc"},
    {"consents", kOfPatient, "recorded_utc"},
    {"restrictions", kOfPatient},
    {"patient_aliases", kOfPatient},
    {"patients", "id = :id", "created_utc"},
}};

Date today() {
  return *date_from_iso(utc_text(std::time(nullptr)).substr(0, 10));
}

/// 29 February becomes 1 March.
Date years_later(Date day, int years) {
  const Date later = day + std::chrono::years(years);
  return later.ok() ? later : later.year() / std::chrono::March / 1;
}

Result<std::optional<Tombstone>> tombstone_of(Access& access, const std::string& code) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  std::optional<Tombstone> found;
  const auto done = parts.database.guard("reading an erased code"_text, [&] {
    Tombstone stone;  // the column makes no difference of capitals
    parts.database.sql() << "SELECT code, erased_utc, erased_by FROM tombstones WHERE code = :code",
        soci::use(code), soci::into(stone.code), soci::into(stone.erased_utc),
        soci::into(stone.erased_by);
    if (parts.database.sql().got_data()) found = stone;
  });
  if (!done) return done.error();
  return found;
}

/// Nobody records while it is held.
Result<RecordingLock> nobody_records(Access& access) {
  auto recording = RecordingLock::exclusive_if_free(access.parts().database.real_path());
  if (recording && !recording->held())
    return failed("another program records into the file now"_text,
                  "end that session, then erase"_text)
        .at(access.path());
  return recording;
}

/// The rows are gone; the file may still hold their bytes.
Result<ErasureDone> sweep_again(Access& access, const Tombstone& stone, const std::string& reason) {
  ErasureDone erasure;
  erasure.erased = true;
  erasure.plan.code = stone.code;
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  const auto recording = nobody_records(access);
  if (!recording) return recording.error();
  const auto done = audited(
      access, "erasing a person"_text, entry_of("erase", stone.code, "0 rows: " + reason),
      [&](AuditEntry&) {
        soci::session& sql = parts.database.sql();
        std::string since;  // of a person that came with a merge: all of the log
        sql << "SELECT coalesce(min(at_utc), '') FROM audit_log WHERE act = 'add patient' AND "
               "result = 'done' AND object = :code COLLATE NOCASE",
            soci::use(stone.code), soci::into(since);
        erasure.remains = remains_of(sql, stone.code, since, stone.erased_utc);
      });
  if (!done) return done.error();
  if (const auto swept = sweep(parts.database); !swept) erasure.not_swept = swept.error();
  return erasure;
}

}  // namespace

Result<ErasurePlan> plan_erasure(Access& access, const std::string& code) {
  if (const auto allowed = access.require(Right::manage, "plan erasure", loggable(code)); !allowed)
    return allowed.error();
  const auto person = find_person(access, code);
  if (!person) return person.error();
  const auto policy = access.policy();
  if (!policy) return policy.error();
  ErasurePlan plan;
  plan.code = person->code;
  plan.restricted = !person->restricted_until.empty();
  const std::lock_guard lock(access.parts().mutex);
  std::string last;
  const auto read = access.parts().database.guard("reading the last record"_text, [&] {
    for (const PersonalTable& table : kPersonal) {
      std::string newest;
      access.parts().database.sql() << "SELECT coalesce(max(" + std::string(table.newest) +
                                           "), '') FROM " + table.name + " WHERE " + table.rows,
          soci::use(person->id), soci::into(newest);
      last = std::max(last, newest);
    }
  });
  if (!read) return read.error();
  const auto day = date_from_iso(last.substr(0, 10));
  if (!day)
    return failed("the day of the last record of %1 cannot be read"_text(person->code),
                  "run isograsp db check"_text)
        .at(access.path());
  const Date keep_until = years_later(*day, policy->retention_years);
  plan.last_record_date = iso_text(*day);
  plan.keep_until_date = iso_text(keep_until);
  plan.may_erase = policy->retention_years == 0 || days_between(keep_until, today()) > 0;
  return plan;
}

Result<ErasureDone> erase_patient(Access& access, const std::string& code,
                                  const std::string& reason) {
  if (const auto good = check_reason(reason); !good) return good.error();
  if (const auto allowed = access.require(Right::manage, "erase", loggable(code)); !allowed)
    return allowed.error();
  const auto stone = tombstone_of(access, code);
  if (!stone) return stone.error();
  if (*stone) return sweep_again(access, **stone, reason);
  const auto plan = plan_erasure(access, code);
  if (!plan) return plan.error();
  const auto person = find_person(access, code);
  if (!person) return person.error();
  ErasureDone erasure;
  erasure.plan = *plan;
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  const auto user = access.user();
  const std::string by = user ? user->name : "";
  const std::string now = utc_text(std::time(nullptr));
  if (!plan->may_erase) {
    const auto done =
        audited(
            access, "restricting records"_text,
            entry_of("restrict", person->code, "until " + plan->keep_until_date + ": " + reason),
            [&](AuditEntry&) {
              parts.database.sql()
                  << "INSERT INTO restrictions (patient_id, since_utc, until_date, requested_by) "
                     "VALUES (:id, :utc, :until, :by) ON CONFLICT (patient_id) DO UPDATE SET "
                     "until_date = excluded.until_date",
                  soci::use(person->id), soci::use(now), soci::use(plan->keep_until_date),
                  soci::use(by);
              erasure.remains =
                  remains_of(parts.database.sql(), person->code, person->created_utc, now);
            });
    if (!done) return done.error();
    erasure.plan.restricted = true;
    return erasure;
  }
  const auto recording = nobody_records(access);
  if (!recording) return recording.error();
  if (const auto wiping = overwrite_what_is_removed(parts.database); !wiping) return wiping.error();
  const auto done = audited(
      access, "erasing a person"_text, entry_of("erase", person->code, reason),
      [&](AuditEntry& entry) {
        soci::session& sql = parts.database.sql();
        erasure.remains = remains_of(sql, person->code, person->created_utc, now);
        std::int64_t all = 0;
        for (const PersonalTable& table : kPersonal) {
          const std::string query =
              "DELETE FROM " + std::string(table.name) + " WHERE " + table.rows;
          soci::statement remove = (sql.prepare << query, soci::use(person->id));
          remove.execute(true);
          const auto count = static_cast<std::int64_t>(remove.get_affected_rows());
          if (count > 0) erasure.rows[table.name] = count;
          all += count;
        }
        sql << "INSERT INTO tombstones (code, erased_utc, erased_by) VALUES (:code, :utc, :by)",
            soci::use(person->code), soci::use(now), soci::use(by);
        entry.detail = std::to_string(all) + " rows: " + reason;
      });
  if (!done) return done.error();
  erasure.erased = true;
  if (const auto swept = sweep(parts.database); !swept) erasure.not_swept = swept.error();
  return erasure;
}

Result<void> lift_restriction(Access& access, const std::string& code, const std::string& reason) {
  if (auto allowed = access.require(Right::manage, "lift restriction", loggable(code)); !allowed)
    return allowed;
  if (auto good = check_reason(reason); !good) return good;
  const auto person = find_person(access, code);
  if (!person) return person.error();
  return audited(access, "lifting a restriction"_text,
                 entry_of("lift restriction", person->code, reason), [&](AuditEntry&) {
                   access.parts().database.sql()
                       << "DELETE FROM restrictions WHERE patient_id = :id",
                       soci::use(person->id);
                 });
}

Result<bool> is_restricted(Access& access, const std::string& code) {
  const auto person = find_person(access, code);
  if (!person) return person.error();
  return !person->restricted_until.empty();
}

Result<std::vector<Tombstone>> tombstones(Access& access) {
  Access::Parts& parts = access.parts();
  const std::lock_guard lock(parts.mutex);
  std::vector<Tombstone> all;
  const auto done = parts.database.guard("reading erased codes"_text, [&] {
    Tombstone one;
    soci::statement select =
        (parts.database.sql().prepare
             << "SELECT code, erased_utc, erased_by FROM tombstones ORDER BY id",
         soci::into(one.code), soci::into(one.erased_utc), soci::into(one.erased_by));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

}  // namespace isograsp::storage
