// SPDX-License-Identifier: GPL-3.0-or-later
// The records of the clinic: patients by code, sessions, trials with their signals (in blocks of
// one second while they are recorded, then packed), measures, events. One SQLite file (WAL,
// synchronous=FULL); format: docs/file_formats.md. A store is used by one thread at a time; several
// stores may be open on one file.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/signals.hpp"
#include "storage/records/profile.hpp"
#include "storage/records/records.hpp"

namespace isograsp::storage {

class SessionStore {
 public:
  virtual ~SessionStore() = default;

  [[nodiscard]] virtual const std::string& path() const noexcept = 0;

  // Writing. Each call is one transaction, durable when it returns (not in a scratch file).
  // All are refused once the file, its write-ahead log or (in a trial) its lock were deleted,
  // moved, replaced, cut off or overwritten by something else.
  /// The same check without writing.
  [[nodiscard]] virtual Result<void> in_place() = 0;
  /// The file was unlinked: what is in it ends with this store, unless save_copy() keeps it.
  [[nodiscard]] virtual bool is_last_hold() = 0;
  /// backup() of such a file: nothing is logged, and nobody is asked for rights: what is sealed
  /// stays sealed.
  [[nodiscard]] virtual Result<void> save_copy(const std::string& to) = 0;
  /// As the file holds it: its text is sealed where the database is protected.
  [[nodiscard]] virtual Result<EventRecord> as_stored(const EventPlace& place,
                                                      const EventRecord& event) = 0;
  /// Which database this is; the same in its copies.
  [[nodiscard]] virtual Result<std::string> database_id() = 0;
  /// `created_utc`, `ended_utc`: ISO 8601; empty: now. `uuid`, also of a session and of a trial
  /// that begin: empty: a new one.
  [[nodiscard]] virtual Result<PatientRecord> add_patient(const std::string& code,
                                                          const std::string& created_utc = "",
                                                          const std::string& uuid = "") = 0;
  /// Takes back somebody who was added by mistake: refused once anything is stored of them.
  [[nodiscard]] virtual Result<void> remove_patient(RowId patient) = 0;
  /// The session with its first answers, both or neither.
  [[nodiscard]] virtual Result<RowId> begin_session(
      const SessionRecord& session, std::span<const SessionAnswer> answers = {}) = 0;
  /// More of them; an item that is answered again counts as answered last.
  [[nodiscard]] virtual Result<void> add_answers(RowId session,
                                                 std::span<const SessionAnswer> answers) = 0;
  [[nodiscard]] virtual Result<void> end_session(RowId session,
                                                 const std::string& ended_utc = "") = 0;
  /// Uses all fields but id.
  [[nodiscard]] virtual Result<RowId> add_preparation(const PreparationRecord& preparation) = 0;
  /// Uses all fields but id, status, samples, dropped, worst_*, drift*, *_json and those of the
  /// screen.
  [[nodiscard]] virtual Result<RowId> begin_trial(const TrialRecord& trial) = 0;
  /// Second number `second` of all groups at once; rows[g] is row-major, columns of group g. Blocks
  /// come in order; all but the last hold rate * 1 s rows.
  [[nodiscard]] virtual Result<void> append_blocks(RowId trial, int second,
                                                   std::span<const std::vector<double>> rows) = 0;
  /// Closes a trial: status, counters, health, timing, screen (display_age_s, viewing_distance_m)
  /// of `end`, references that it did not begin with, and its measures. Then packs its signals, in
  /// a transaction of its own: if that does not succeed, the trial is stored all the same, in
  /// blocks of a second, and an event `storage` of the session says why.
  [[nodiscard]] virtual Result<void> end_trial(const TrialRecord& end,
                                               std::span<const Measure> measures) = 0;
  /// Results of newer definitions for trials of one person that have ended: of each measure (name,
  /// channel, unit) that is stored with older versions only, the new one is put beside them; what
  /// is stored is not changed. One transaction, with its entry in the audit log. False, and nothing
  /// done: the file was opened to read, somebody records into it or writes just now, or who is
  /// logged in may not write. Trials of people whose records are restricted are passed over.
  [[nodiscard]] virtual Result<bool> add_newer_measures(RowId patient,
                                                        std::span<const ScoredTrial> trials) = 0;
  [[nodiscard]] virtual Result<void> add_event(RowId session, const EventRecord& event) = 0;
  [[nodiscard]] virtual Result<RowId> add_rating(const RatingRecord& rating) = 0;
  /// Effort and pains of the stored rating `rating.id` become these; what they were is kept in an
  /// event of the session (kCorrectionEvent) at `rating.session_time_s`. The time at which they
  /// were asked is not changed.
  [[nodiscard]] virtual Result<void> correct_rating(const RatingRecord& rating) = 0;
  /// Of a trial that has ended.
  [[nodiscard]] virtual Result<void> mark_helped(RowId trial, bool helped) = 0;

  // What is known of a person. Refused with the field that makes no sense
  // (storage/records/profile.hpp).
  /// Replaces the profile; what it was is not kept.
  [[nodiscard]] virtual Result<void> set_profile(RowId patient, const PatientProfile& profile) = 0;
  /// Uses all fields but id.
  [[nodiscard]] virtual Result<RowId> add_treatment_mark(RowId patient,
                                                         const TreatmentMark& mark) = 0;
  [[nodiscard]] virtual Result<void> remove_treatment_mark(RowId id) = 0;
  /// Uses all fields but id.
  [[nodiscard]] virtual Result<RowId> add_clinical_score(RowId patient,
                                                         const ClinicalScore& score) = 0;
  [[nodiscard]] virtual Result<void> remove_clinical_score(RowId id) = 0;
  /// Uses all fields but id; `chosen_utc` empty: now. Refused: one that is there already, a fifth.
  [[nodiscard]] virtual Result<RowId> add_primary_measure(RowId patient,
                                                          const PrimaryMeasure& primary) = 0;
  [[nodiscard]] virtual Result<void> remove_primary_measure(RowId id) = 0;
  /// Uses all fields but id; `judged_utc` empty: now. Refused: one that overlaps another.
  [[nodiscard]] virtual Result<RowId> add_stable_period(RowId patient,
                                                        const StablePeriod& period) = 0;
  [[nodiscard]] virtual Result<void> remove_stable_period(RowId id) = 0;

  // Reading.
  [[nodiscard]] virtual Result<std::vector<PatientRecord>> patients() = 0;
  [[nodiscard]] virtual Result<std::optional<PatientRecord>> find_patient(
      const std::string& code) = 0;
  /// Nothing in it: nothing is known.
  [[nodiscard]] virtual Result<PatientProfile> profile(RowId patient) = 0;
  /// By date.
  [[nodiscard]] virtual Result<std::vector<TreatmentMark>> treatment_marks(RowId patient) = 0;
  /// By date.
  [[nodiscard]] virtual Result<std::vector<ClinicalScore>> clinical_scores(RowId patient) = 0;
  /// In the order in which they were chosen.
  [[nodiscard]] virtual Result<std::vector<PrimaryMeasure>> primary_measures(RowId patient) = 0;
  /// By date.
  [[nodiscard]] virtual Result<std::vector<StablePeriod>> stable_periods(RowId patient) = 0;
  /// One measure of the assessments of all people on the days on which they are judged stable:
  /// completed trials, neither practice nor helped. By person, then oldest first.
  [[nodiscard]] virtual Result<std::vector<PooledValue>> stable_values(const PoolQuery& query) = 0;
  /// The same of the people of whom neither side is affected, of whatever day.
  [[nodiscard]] virtual Result<std::vector<PooledValue>> healthy_values(const PoolQuery& query) = 0;
  /// False: the last answer about research was no, or the person's records are restricted.
  [[nodiscard]] virtual Result<bool> may_be_used_for_research(RowId patient) = 0;
  /// The last answer about a purpose ("treatment", "research"): "given", "refused", "withdrawn";
  /// empty: none is on record.
  [[nodiscard]] virtual Result<std::string> consent_state(RowId patient,
                                                          const std::string& purpose) = 0;
  [[nodiscard]] virtual Result<std::vector<SessionRecord>> sessions(RowId patient) = 0;
  /// Of all patients, newest first.
  [[nodiscard]] virtual Result<std::vector<SessionRecord>> recent_sessions(int most) = 0;
  /// In the order in which they were given.
  [[nodiscard]] virtual Result<std::vector<SessionAnswer>> answers(RowId session) = 0;
  [[nodiscard]] virtual Result<std::vector<TrialRecord>> trials(RowId session) = 0;
  /// Of each measure the newest version that is stored.
  [[nodiscard]] virtual Result<std::vector<Measure>> measures(RowId trial) = 0;
  /// All that is stored: the results of older versions, too.
  [[nodiscard]] virtual Result<std::vector<Measure>> measures_of_all_versions(RowId trial) = 0;
  [[nodiscard]] virtual Result<std::vector<EventRecord>> events(RowId session) = 0;
  /// Of every kind.
  [[nodiscard]] virtual Result<std::vector<PreparationRecord>> preparations(RowId session) = 0;
  /// The newest of a kind with the device of `session`, whichever session it was made in: same
  /// serial numbers, or same URI where not all sensors tell theirs. Simulated and real devices are
  /// never the same.
  [[nodiscard]] virtual Result<std::optional<PreparationRecord>> last_preparation(
      const SessionRecord& session, const std::string& kind) = 0;
  [[nodiscard]] virtual Result<std::vector<RatingRecord>> ratings(RowId session) = 0;
  /// All groups of a trial side by side, in the order of trial.groups. Fails on a damaged block,
  /// naming it. With fewer groups or samples than the trial has: the first ones.
  [[nodiscard]] virtual Result<Signals> signals(const TrialRecord& trial) = 0;
  /// Every measure of a patient's completed trials in its newest version, oldest trial first.
  [[nodiscard]] virtual Result<std::vector<MeasurePoint>> progress(RowId patient) = 0;

  // Care.
  /// integrity_check, foreign keys, every block readable, dates and scores possible. The list of
  /// problems; empty: sound.
  [[nodiscard]] virtual Result<std::vector<Text>> check() = 0;
  /// Online copy into a new file, then checked.
  [[nodiscard]] virtual Result<void> backup(const std::string& to) = 0;
};

}  // namespace isograsp::storage
