// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/access/guarded_store.hpp"

#include <ctime>
#include <filesystem>
#include <optional>

#include <soci/soci.h>

#include "core/files.hpp"
#include "core/time.hpp"
#include "storage/access/audit_chain.hpp"
#include "storage/access/clinic_key.hpp"
#include "storage/access/proof.hpp"
#include "storage/file/open_mode.hpp"
#include "storage/records/patient_code.hpp"

namespace isograsp::storage {

using namespace sealed_column;

Result<std::shared_ptr<LoginState>> login_at(Database& database, bool writable) {
  std::shared_ptr<LoginState> state;
  const auto read = database.guard("opening"_text, [&] { state = login_state_of(database); });
  if (!read) return read.error();
  if (state->is_protected()) {
    const auto user = state->login().user;
    if (!user) return refusal_of(*state, Right::read_records, database.path());
    if (writable && !may(user->role, Right::write_records))
      return refusal_of(*state, Right::write_records, database.path());
  }
  return state;
}

namespace {

TextPlace text_place(const EventPlace& place, const EventRecord& event) {
  return {kEventText, place.patient_code, row_words(place, event)};
}

}  // namespace

GuardedStore::GuardedStore(std::unique_ptr<SqliteStore> store, std::shared_ptr<LoginState> state)
    : ForwardingStore(std::move(store)), state_(std::move(state)) {}

template <class Work>
auto GuardedStore::logged(const char* act, const std::string& object, std::string detail, Work work,
                          const std::function<void(AuditEntry&)>& complete) -> decltype(work()) {
  AuditEntry entry = entry_of(act, object, std::move(detail));
  const auto work_if_allowed = [&]() -> decltype(work()) {
    if (const auto allowed = may_write(); !allowed) return allowed.error();
    return work();
  };
  return audited(database(), *state_, entry, work_if_allowed, complete);
}

Result<void> GuardedStore::may_write() const {
  if (!state_->is_protected()) return {};
  const auto user = state_->login().user;
  if (!user || !may(user->role, Right::write_records))
    return refusal_of(*state_, Right::write_records, path());
  return {};
}

std::string GuardedStore::query_text(const std::string& query, RowId id) {
  std::string text;
  const auto read = database().guard("reading a code"_text, [&] {
    database().sql() << query, soci::use(id), soci::into(text);
    if (!database().sql().got_data()) text.clear();
  });
  return read ? text : "";  // what follows fails then, and says why
}

std::string GuardedStore::code_of(RowId patient) {
  return query_text("SELECT code FROM patients WHERE id = :id", patient);
}

std::string GuardedStore::code_of_session(RowId session) {
  return query_text(
      "SELECT p.code FROM sessions s JOIN patients p ON p.id = s.patient_id WHERE s.id = :id",
      session);
}

Result<void> GuardedStore::close(std::string& text, const TextPlace& place) {
  return seal_text(*state_, text, place);
}

Result<void> GuardedStore::open(std::string& text, const TextPlace& place) {
  return open_text(*state_, text, place, database());
}

EventPlace GuardedStore::place_of(RowId session, const EventRecord& event) {
  EventPlace place{code_of_session(session),
                   query_text("SELECT coalesce(uuid, '') FROM sessions WHERE id = :id", session)};
  if (event.trial_id)
    place.trial_uuid =
        query_text("SELECT coalesce(uuid, '') FROM trials WHERE id = :id", *event.trial_id);
  return place;
}

Result<PatientRecord> GuardedStore::add_patient(const std::string& code,
                                                const std::string& created_utc,
                                                const std::string& uuid) {
  // What is no code may be a name: it does not reach the log.
  if (const auto allowed = check_patient_code(code); !allowed) return allowed.error();
  std::string erased;
  const auto read = database().guard("reading erased codes"_text, [&] {
    database().sql() << "SELECT code FROM tombstones WHERE code = :code", soci::use(code),
        soci::into(erased);
  });
  if (!read) return read.error();
  if (!erased.empty())
    return refused("patient %1 was erased: the code is not given again"_text(erased),
                   "choose another code"_text)
        .at(behind().path());
  return logged("add patient", code, "",
                [&] { return behind().add_patient(code, created_utc, uuid); });
}

Result<void> GuardedStore::remove_patient(RowId patient) {
  return logged("remove patient", code_of(patient), "",
                [&] { return behind().remove_patient(patient); });
}

Result<RowId> GuardedStore::begin_session(const SessionRecord& session,
                                          std::span<const SessionAnswer> answers) {
  const std::string code = code_of(session.patient_id);
  const std::string until =
      query_text("SELECT until_date FROM restrictions WHERE patient_id = :id", session.patient_id);
  if (!until.empty())
    return refused("the records of %1 are restricted until %2: the person asked for erasure"_text(
                       code, until),
                   "lift the restriction if the person wishes to go on"_text)
        .at(behind().path());
  return logged(
      "begin session", code, "", [&] { return behind().begin_session(session, answers); },
      [&](AuditEntry& entry) {
        int id = 0;
        database().sql() << "SELECT max(id) FROM sessions", soci::into(id);
        entry.detail = "session " + std::to_string(id) + ", " + std::string(name_of(session.hand)) +
                       " hand" + (session.simulated ? ", simulated" : "");
      });
}

Result<void> GuardedStore::add_answers(RowId session, std::span<const SessionAnswer> answers) {
  if (auto allowed = may_write(); !allowed) return allowed;
  return behind().add_answers(session, answers);
}

Result<RowId> GuardedStore::add_preparation(const PreparationRecord& preparation) {
  if (const auto allowed = may_write(); !allowed) return allowed.error();
  return behind().add_preparation(preparation);
}

Result<RowId> GuardedStore::begin_trial(const TrialRecord& trial) {
  if (const auto allowed = may_write(); !allowed) return allowed.error();
  return behind().begin_trial(trial);
}

Result<RowId> GuardedStore::add_rating(const RatingRecord& rating) {
  if (const auto allowed = may_write(); !allowed) return allowed.error();
  return behind().add_rating(rating);
}

Result<void> GuardedStore::correct_rating(const RatingRecord& rating) {
  if (auto allowed = may_write(); !allowed) return allowed;
  return behind().correct_rating(rating);
}

Result<void> GuardedStore::mark_helped(RowId trial, bool helped) {
  if (auto allowed = may_write(); !allowed) return allowed;
  return behind().mark_helped(trial, helped);
}

Result<bool> GuardedStore::add_newer_measures(RowId patient, std::span<const ScoredTrial> trials) {
  if (!may_write()) return false;  // who may only read still gets the report
  AuditEntry entry = entry_of("recompute measures", code_of(patient));
  AuditHead head;
  auto done = behind().insert_newer_measures(patient, trials, [&](const SqliteStore::Added& added) {
    if (added.results == 0) return;
    entry.detail =
        std::to_string(added.results) + " results of " + std::to_string(added.trials) + " trials";
    head = append_audit(database(), *state_, entry);
  });
  if (done && *done) note_head(database(), *state_, head);
  return done;
}

Result<void> GuardedStore::end_session(RowId session, const std::string& ended_utc) {
  AuditEntry entry =
      entry_of("end session", code_of_session(session), "session " + std::to_string(session));
  return audited(database(), *state_, entry,
                 [&] { return behind().end_session(session, ended_utc); });
}

Result<void> GuardedStore::add_event(RowId session, const EventRecord& event) {
  if (event.kind != kSealedEvent) return behind().add_event(session, event);
  const auto stored = as_stored(place_of(session, event), event);
  if (!stored) return stored.error();
  return behind().add_event(session, *stored);
}

Result<EventRecord> GuardedStore::as_stored(const EventPlace& place, const EventRecord& event) {
  EventRecord sealed = event;
  if (event.kind == kSealedEvent)
    if (const auto done = close(sealed.text, text_place(place, event)); !done) return done.error();
  return sealed;
}

Result<std::vector<EventRecord>> GuardedStore::events(RowId session) {
  auto all = behind().events(session);
  if (!all || !state_->is_protected()) return all;
  for (EventRecord& event : *all)
    if (event.kind == kSealedEvent)
      if (const auto done = open(event.text, text_place(place_of(session, event), event)); !done)
        return done.error();
  return all;
}

Result<void> GuardedStore::set_profile(RowId patient, const PatientProfile& profile) {
  const std::string code = code_of(patient);
  PatientProfile sealed = profile;
  if (auto done = close(sealed.notes, {kNotes, code, row_words(profile)}); !done) return done;
  if (auto done = close(sealed.goals, {kGoals, code, row_words(profile)}); !done) return done;
  return logged("change profile", code, "profile",
                [&] { return behind().set_profile(patient, sealed); });
}

Result<PatientProfile> GuardedStore::profile(RowId patient) {
  auto profile = behind().profile(patient);
  if (!profile || !state_->is_protected()) return profile;
  const std::string code = code_of(patient);
  const RowWords words = row_words(*profile);
  if (const auto done = open(profile->notes, {kNotes, code, words}); !done) return done.error();
  if (const auto done = open(profile->goals, {kGoals, code, words}); !done) return done.error();
  return profile;
}

Result<RowId> GuardedStore::add_treatment_mark(RowId patient, const TreatmentMark& mark) {
  const std::string code = code_of(patient);
  TreatmentMark sealed = mark;
  if (const auto done = close(sealed.text, {kMarkText, code, row_words(mark)}); !done)
    return done.error();
  return logged("change profile", code, "treatment mark added",
                [&] { return behind().add_treatment_mark(patient, sealed); });
}

Result<std::vector<TreatmentMark>> GuardedStore::treatment_marks(RowId patient) {
  auto all = behind().treatment_marks(patient);
  if (!all || !state_->is_protected()) return all;
  const std::string code = code_of(patient);
  for (TreatmentMark& mark : *all)
    if (const auto done = open(mark.text, {kMarkText, code, row_words(mark)}); !done)
      return done.error();
  return all;
}

Result<RowId> GuardedStore::add_clinical_score(RowId patient, const ClinicalScore& score) {
  const std::string code = code_of(patient);
  ClinicalScore sealed = score;
  if (const auto done = close(sealed.text, {kScoreText, code, row_words(score)}); !done)
    return done.error();
  return logged("change profile", code, "clinical score added",
                [&] { return behind().add_clinical_score(patient, sealed); });
}

Result<std::vector<ClinicalScore>> GuardedStore::clinical_scores(RowId patient) {
  auto all = behind().clinical_scores(patient);
  if (!all || !state_->is_protected()) return all;
  const std::string code = code_of(patient);
  for (ClinicalScore& score : *all)
    if (const auto done = open(score.text, {kScoreText, code, row_words(score)}); !done)
      return done.error();
  return all;
}

Result<RowId> GuardedStore::add_primary_measure(RowId patient, const PrimaryMeasure& primary) {
  const std::string code = code_of(patient);
  PrimaryMeasure sealed = primary;
  if (sealed.chosen_utc.empty()) sealed.chosen_utc = utc_text(std::time(nullptr));
  if (const auto done = close(sealed.chosen_by, {kChosenBy, code, row_words(sealed)}); !done)
    return done.error();
  return logged("change profile", code, "primary measure added",
                [&] { return behind().add_primary_measure(patient, sealed); });
}

Result<std::vector<PrimaryMeasure>> GuardedStore::primary_measures(RowId patient) {
  auto all = behind().primary_measures(patient);
  if (!all || !state_->is_protected()) return all;
  const std::string code = code_of(patient);
  for (PrimaryMeasure& primary : *all)
    if (const auto done = open(primary.chosen_by, {kChosenBy, code, row_words(primary)}); !done)
      return done.error();
  return all;
}

Result<RowId> GuardedStore::add_stable_period(RowId patient, const StablePeriod& period) {
  const std::string code = code_of(patient);
  StablePeriod sealed = period;
  if (sealed.judged_utc.empty()) sealed.judged_utc = utc_text(std::time(nullptr));
  const RowWords words = row_words(sealed);
  if (const auto done = close(sealed.judged_by, {kJudgedBy, code, words}); !done)
    return done.error();
  if (const auto done = close(sealed.text, {kPeriodText, code, words}); !done) return done.error();
  return logged("change profile", code, "stable time added",
                [&] { return behind().add_stable_period(patient, sealed); });
}

Result<std::vector<StablePeriod>> GuardedStore::stable_periods(RowId patient) {
  auto all = behind().stable_periods(patient);
  if (!all || !state_->is_protected()) return all;
  const std::string code = code_of(patient);
  for (StablePeriod& period : *all) {
    const RowWords words = row_words(period);
    if (const auto done = open(period.judged_by, {kJudgedBy, code, words}); !done)
      return done.error();
    if (const auto done = open(period.text, {kPeriodText, code, words}); !done) return done.error();
  }
  return all;
}

template <class Work>
Result<void> GuardedStore::removed(const char* table, const char* what, RowId id, Work work) {
  const std::string code =
      query_text("SELECT p.code FROM " + std::string(table) +
                     " x JOIN patients p ON p.id = x.patient_id WHERE x.id = :id",
                 id);
  return logged("change profile", code, std::string(what) + " removed", work);
}

Result<void> GuardedStore::remove_treatment_mark(RowId id) {
  return removed("treatment_marks", "treatment mark", id,
                 [&] { return behind().remove_treatment_mark(id); });
}

Result<void> GuardedStore::remove_clinical_score(RowId id) {
  return removed("clinical_scores", "clinical score", id,
                 [&] { return behind().remove_clinical_score(id); });
}

Result<void> GuardedStore::remove_primary_measure(RowId id) {
  return removed("primary_measures", "primary measure", id,
                 [&] { return behind().remove_primary_measure(id); });
}

Result<void> GuardedStore::remove_stable_period(RowId id) {
  return removed("stable_periods", "stable time", id,
                 [&] { return behind().remove_stable_period(id); });
}

Result<std::vector<Text>> GuardedStore::check() {
  auto problems = behind().check_through(*this);
  if (!problems) return problems;
  const auto changes = changes_by_others(database(), *state_);
  if (!changes) return changes.error();
  problems->insert(problems->end(), changes->begin(), changes->end());
  return problems;
}

Result<void> GuardedStore::backup(const std::string& to) {
  // One of before would stand beside a file that it is not of.
  std::error_code ignored;
  const std::string beside = signature_file_of(to);
  if (!to.empty() && !std::filesystem::exists(std::filesystem::symlink_status(to, ignored)))
    std::filesystem::remove(beside, ignored);
  std::optional<FileSignature> signature;
  auto copied = behind().copy_if_sound(to, [&](Database& copy) {
    auto problems = changes_by_others(copy, *state_);
    if (!problems || !problems->empty()) return problems;
    // Of what was checked just now, before others can reach it under its name.
    const auto seed = signing_seed(database(), *state_, true);
    if (!seed) return problems;
    auto made =
        signature_of(*seed, copy.real_path(), SignedKind::backup, utc_text(std::time(nullptr)));
    if (!made) return Result<std::vector<Text>>(made.error());
    signature = *std::move(made);
    return problems;
  });
  if (copied && signature) copied = write_text(beside, written(*signature));
  if (database().format() != kDatabaseFormat || !may_be_written(path())) return copied;
  // On a connection of its own: a store that only reads makes backups, too.
  auto log = Database::open(path(), OpenMode::existing);
  if (!log) return log.error();
  AuditEntry entry = entry_of("backup", std::filesystem::path(to).filename(),
                              signature ? "signed " + signature->key : "not signed");
  if (!copied) entry.result = "failed";
  const auto written = audited(*log, *state_, entry,
                               [&] { return log->transact("writing the audit log"_text, [] {}); });
  return copied ? written : copied;
}

}  // namespace isograsp::storage
