// SPDX-License-Identifier: GPL-3.0-or-later
// Profiles, treatment marks, clinical scores and answers: written and read.
#include <soci/soci.h>

#include "core/csv.hpp"
#include "storage/file/schema_access.hpp"
#include "storage/sqlite/row.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

namespace {

constexpr int kProfileSinceFormat = 4;

}  // namespace

void SqliteStore::require(const char* table, Words one, RowId id) {
  int present = 0;
  database_.sql() << "SELECT count(*) FROM " + std::string(table) + " WHERE id = :id",
      soci::use(id), soci::into(present);
  if (present == 0)
    throw Refusal{refused("there is no %1 number %2"_text(one, id), "read what there is again"_text)
                      .at(path())};
}

Result<PatientProfile> SqliteStore::profile(RowId patient) {
  PatientProfile profile;
  if (database_.format() < kProfileSinceFormat) return profile;
  const auto done = database_.guard("reading a profile"_text, [&] {
    Row row(database_.sql());
    row.get("affected", profile.affected, side_from_name)
        .get("dominant", profile.dominant, hand_from_name)
        .get("sex", profile.sex, sex_from_name)
        .get("birth_year", profile.birth_year)
        .get("onset_date", profile.onset_date)
        .get("notes", profile.notes)
        .get("goals", profile.goals);
    row.select("FROM patient_profiles WHERE patient_id = :patient", {patient});
    static_cast<void>(row.fetch());
  });
  if (!done) return done.error();
  return profile;
}

Result<void> SqliteStore::set_profile(RowId patient, const PatientProfile& profile) {
  if (auto good = check_profile(profile); !good) return good;
  const std::string affected(profile.affected ? name_of(*profile.affected) : "");
  const std::string dominant(profile.dominant ? name_of(*profile.dominant) : "");
  const std::string sex(profile.sex ? name_of(*profile.sex) : "");
  const int birth_year = profile.birth_year.value_or(0);
  return database_.transact("storing a profile"_text, [&] {
    require("patients", "patient"_text, patient);
    database_.sql()
        << "INSERT INTO patient_profiles (patient_id, affected, dominant, sex, birth_year, "
           "onset_date, notes, goals) VALUES (:patient, :affected, :dominant, :sex, "
           "nullif(:born, 0), :onset, :notes, :goals) "
           "ON CONFLICT (patient_id) DO UPDATE SET affected = excluded.affected, "
           "dominant = excluded.dominant, sex = excluded.sex, birth_year = excluded.birth_year, "
           "onset_date = excluded.onset_date, notes = excluded.notes, goals = excluded.goals",
        soci::use(patient), soci::use(affected), soci::use(dominant), soci::use(sex),
        soci::use(birth_year), soci::use(profile.onset_date), soci::use(profile.notes),
        soci::use(profile.goals);
  });
}

Result<bool> SqliteStore::may_be_used_for_research(RowId patient) {
  if (database_.format() < schema::kAccessFormat) return true;
  bool may = true;
  const auto done = database_.guard("reading a consent"_text, [&] {
    int restricted = 0;
    std::string state;
    database_.sql() << "SELECT (SELECT count(*) FROM restrictions WHERE patient_id = :restricted), "
                       "coalesce((SELECT state FROM consents WHERE patient_id = :asked "
                       "AND purpose = 'research' ORDER BY recorded_utc DESC, id DESC LIMIT 1), '')",
        soci::use(patient), soci::use(patient), soci::into(restricted), soci::into(state);
    may = restricted == 0 && (state.empty() || state == "given");
  });
  if (!done) return done.error();
  return may;
}

Result<std::string> SqliteStore::consent_state(RowId patient, const std::string& purpose) {
  std::string state;
  if (database_.format() < schema::kAccessFormat) return state;
  const auto done = database_.guard("reading a consent"_text, [&] {
    database_.sql() << "SELECT coalesce((SELECT state FROM consents WHERE patient_id = :patient "
                       "AND purpose = :purpose ORDER BY recorded_utc DESC, id DESC LIMIT 1), '')",
        soci::use(patient), soci::use(purpose), soci::into(state);
  });
  if (!done) return done.error();
  return state;
}

Result<std::vector<TreatmentMark>> SqliteStore::treatment_marks(RowId patient) {
  std::vector<TreatmentMark> all;
  if (database_.format() < kProfileSinceFormat) return all;
  const auto done = database_.guard("reading treatment marks"_text, [&] {
    TreatmentMark one;
    soci::statement select =
        (database_.sql().prepare << "SELECT id, on_date, kind, text FROM treatment_marks "
                                    "WHERE patient_id = :patient ORDER BY on_date, id",
         soci::use(patient), soci::into(one.id), soci::into(one.on_date), soci::into(one.kind),
         soci::into(one.text));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<RowId> SqliteStore::add_treatment_mark(RowId patient, const TreatmentMark& mark) {
  if (const auto good = check_treatment_mark(mark); !good) return good.error();
  RowId id = 0;
  const auto done = database_.transact("storing a treatment mark"_text, [&] {
    require("patients", "patient"_text, patient);
    soci::session& sql = database_.sql();
    sql << "INSERT INTO treatment_marks (patient_id, on_date, kind, text) "
           "VALUES (:patient, :date, :kind, :text)",
        soci::use(patient), soci::use(mark.on_date), soci::use(mark.kind), soci::use(mark.text);
    id = last_id(sql, "treatment_marks");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::remove_treatment_mark(RowId id) {
  return database_.transact("removing a treatment mark"_text, [&] {
    require("treatment_marks", "treatment mark"_text, id);
    database_.sql() << "DELETE FROM treatment_marks WHERE id = :id", soci::use(id);
  });
}

Result<std::vector<ClinicalScore>> SqliteStore::clinical_scores(RowId patient) {
  std::vector<ClinicalScore> all;
  if (database_.format() < kProfileSinceFormat) return all;
  const auto done = database_.guard("reading clinical scores"_text, [&] {
    ClinicalScore one;
    soci::statement select =
        (database_.sql().prepare << "SELECT id, on_date, scale, value, text FROM clinical_scores "
                                    "WHERE patient_id = :patient ORDER BY on_date, id",
         soci::use(patient), soci::into(one.id), soci::into(one.on_date), soci::into(one.scale),
         soci::into(one.value), soci::into(one.text));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

Result<RowId> SqliteStore::add_clinical_score(RowId patient, const ClinicalScore& score) {
  if (const auto good = check_clinical_score(score); !good) return good.error();
  RowId id = 0;
  const auto done = database_.transact("storing a clinical score"_text, [&] {
    require("patients", "patient"_text, patient);
    soci::session& sql = database_.sql();
    sql << "INSERT INTO clinical_scores (patient_id, on_date, scale, value, text) "
           "VALUES (:patient, :date, :scale, :value, :text)",
        soci::use(patient), soci::use(score.on_date), soci::use(score.scale),
        soci::use(score.value), soci::use(score.text);
    id = last_id(sql, "clinical_scores");
  });
  if (!done) return done.error();
  return id;
}

Result<void> SqliteStore::remove_clinical_score(RowId id) {
  return database_.transact("removing a clinical score"_text, [&] {
    require("clinical_scores", "clinical score"_text, id);
    database_.sql() << "DELETE FROM clinical_scores WHERE id = :id", soci::use(id);
  });
}

void SqliteStore::insert_answers(RowId session, std::span<const SessionAnswer> answers) {
  for (const SessionAnswer& answer : answers) {
    if (const auto good = check_answer(answer); !good) throw Refusal{good.error()};
    database_.sql() << "INSERT INTO session_answers (session_id, topic, item, value) "
                       "VALUES (:session, :topic, :item, :value)",
        soci::use(session), soci::use(answer.topic), soci::use(answer.item),
        soci::use(answer.value);
  }
}

Result<void> SqliteStore::add_answers(RowId session, std::span<const SessionAnswer> answers) {
  return database_.transact("storing answers"_text, [&] {
    require("sessions", "session"_text, session);
    insert_answers(session, answers);
  });
}

Result<std::vector<SessionAnswer>> SqliteStore::answers(RowId session) {
  std::vector<SessionAnswer> all;
  if (database_.format() < kProfileSinceFormat) return all;
  const auto done = database_.guard("reading answers"_text, [&] {
    SessionAnswer one;
    soci::statement select =
        (database_.sql().prepare << "SELECT topic, item, value FROM session_answers "
                                    "WHERE session_id = :session ORDER BY id",
         soci::use(session), soci::into(one.topic), soci::into(one.item), soci::into(one.value));
    select.execute();
    while (select.fetch()) all.push_back(one);
  });
  if (!done) return done.error();
  return all;
}

std::string display_delay_query(const std::string& session) {
  return "coalesce((SELECT value FROM session_answers WHERE session_id = " + session +
         " AND topic = 'screen' AND item = 'display_delay_s' ORDER BY id DESC LIMIT 1), '')";
}

std::optional<double> display_delay_from(const std::string& answer) {
  double delay_s = 0.0;
  return parse_number(answer, delay_s) ? std::optional(delay_s) : std::nullopt;
}

Result<void> check_told(SessionStore& store, std::vector<Text>& problems) {
  const auto all = store.patients();
  if (!all) return all.error();
  for (const PatientRecord& patient : *all) {
    // What could not be read, and why.
    const auto note = [&](const auto& good, const Text& what) {
      if (!good)
        problems.push_back("%1 of %2: %3"_text(what, patient.code, words_of(good.error())));
      return good.ok();
    };
    if (const auto told = store.profile(patient.id); note(told, "profile"_text))
      note(check_profile(*told), "profile"_text);
    if (const auto marks = store.treatment_marks(patient.id); note(marks, "treatment marks"_text))
      for (const auto& mark : *marks)
        note(check_treatment_mark(mark), "treatment mark %1"_text(mark.id));
    if (const auto scores = store.clinical_scores(patient.id); note(scores, "clinical scores"_text))
      for (const auto& score : *scores)
        note(check_clinical_score(score), "clinical score %1"_text(score.id));
    if (const auto primaries = store.primary_measures(patient.id);
        note(primaries, "primary measures"_text)) {
      for (const auto& primary : *primaries)
        note(check_primary_measure(primary), "primary measure %1"_text(primary.id));
      if (primaries->size() > kMostPrimaryMeasures)
        problems.push_back(
            "%1 has more than %2 primary measures"_text(patient.code, kMostPrimaryMeasures));
    }
    const auto periods = store.stable_periods(patient.id);
    if (!note(periods, "stable times"_text)) continue;
    for (std::size_t i = 0; i < periods->size(); ++i) {
      const StablePeriod& period = (*periods)[i];
      note(check_stable_period(period), "stable time %1"_text(period.id));
      if (i > 0 && period.from_date <= (*periods)[i - 1].until_date)
        problems.push_back("stable times of %1 overlap on %2"_text(patient.code, period.from_date));
    }
  }
  return {};
}

}  // namespace isograsp::storage
