// SPDX-License-Identifier: GPL-3.0-or-later
// Inside storage/ only: the session store on SQLite; open_store() gives one behind its guard
// (access/guarded_store.hpp). Writing is in write_records.cpp, write_trial.cpp, newer_measures.cpp
// and packing.cpp, reading in read_records.cpp, read_session_parts.cpp and read_signals.cpp, both
// for what is known of a person in profile_records.cpp and change_records.cpp, care in
// maintenance.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "storage/crypto/content_hash.hpp"
#include "storage/file/database.hpp"
#include "storage/records/session_store.hpp"
#include "storage/sqlite/block_codec.hpp"

namespace isograsp::storage {

class SqliteStore final : public SessionStore {
 public:
  explicit SqliteStore(Database database);
  ~SqliteStore() override;

  [[nodiscard]] const std::string& path() const noexcept override { return database_.path(); }

  [[nodiscard]] Result<PatientRecord> add_patient(const std::string& code,
                                                  const std::string& created_utc,
                                                  const std::string& uuid) override;
  [[nodiscard]] Result<void> remove_patient(RowId patient) override;
  [[nodiscard]] Result<void> in_place() override;
  [[nodiscard]] bool is_last_hold() override { return database_.is_last_hold(); }
  [[nodiscard]] Result<void> save_copy(const std::string& to) override;
  [[nodiscard]] Result<EventRecord> as_stored(const EventPlace& place,
                                              const EventRecord& event) override;
  [[nodiscard]] Result<std::string> database_id() override;
  [[nodiscard]] Result<RowId> begin_session(const SessionRecord& session,
                                            std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<void> add_answers(RowId session,
                                         std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<void> end_session(RowId session, const std::string& ended_utc) override;
  [[nodiscard]] Result<RowId> add_preparation(const PreparationRecord& preparation) override;
  [[nodiscard]] Result<RowId> begin_trial(const TrialRecord& trial) override;
  [[nodiscard]] Result<void> append_blocks(RowId trial, int second,
                                           std::span<const std::vector<double>> rows) override;
  [[nodiscard]] Result<void> end_trial(const TrialRecord& end,
                                       std::span<const Measure> measures) override;
  [[nodiscard]] Result<bool> add_newer_measures(RowId patient,
                                                std::span<const ScoredTrial> trials) override;
  [[nodiscard]] Result<void> add_event(RowId session, const EventRecord& event) override;
  [[nodiscard]] Result<RowId> add_rating(const RatingRecord& rating) override;
  [[nodiscard]] Result<void> correct_rating(const RatingRecord& rating) override;
  [[nodiscard]] Result<void> mark_helped(RowId trial, bool helped) override;
  [[nodiscard]] Result<void> set_profile(RowId patient, const PatientProfile& profile) override;
  [[nodiscard]] Result<RowId> add_treatment_mark(RowId patient, const TreatmentMark& mark) override;
  [[nodiscard]] Result<void> remove_treatment_mark(RowId id) override;
  [[nodiscard]] Result<RowId> add_clinical_score(RowId patient,
                                                 const ClinicalScore& score) override;
  [[nodiscard]] Result<void> remove_clinical_score(RowId id) override;
  [[nodiscard]] Result<RowId> add_primary_measure(RowId patient,
                                                  const PrimaryMeasure& primary) override;
  [[nodiscard]] Result<void> remove_primary_measure(RowId id) override;
  [[nodiscard]] Result<RowId> add_stable_period(RowId patient, const StablePeriod& period) override;
  [[nodiscard]] Result<void> remove_stable_period(RowId id) override;

  [[nodiscard]] Result<std::vector<PatientRecord>> patients() override;
  [[nodiscard]] Result<std::optional<PatientRecord>> find_patient(const std::string& code) override;
  [[nodiscard]] Result<PatientProfile> profile(RowId patient) override;
  [[nodiscard]] Result<std::vector<TreatmentMark>> treatment_marks(RowId patient) override;
  [[nodiscard]] Result<std::vector<ClinicalScore>> clinical_scores(RowId patient) override;
  [[nodiscard]] Result<std::vector<PrimaryMeasure>> primary_measures(RowId patient) override;
  [[nodiscard]] Result<std::vector<StablePeriod>> stable_periods(RowId patient) override;
  [[nodiscard]] Result<std::vector<PooledValue>> stable_values(const PoolQuery& query) override;
  [[nodiscard]] Result<std::vector<PooledValue>> healthy_values(const PoolQuery& query) override;
  [[nodiscard]] Result<bool> may_be_used_for_research(RowId patient) override;
  [[nodiscard]] Result<std::string> consent_state(RowId patient,
                                                  const std::string& purpose) override;
  [[nodiscard]] Result<std::vector<SessionRecord>> sessions(RowId patient) override;
  [[nodiscard]] Result<std::vector<SessionRecord>> recent_sessions(int most) override;
  [[nodiscard]] Result<std::vector<SessionAnswer>> answers(RowId session) override;
  [[nodiscard]] Result<std::vector<TrialRecord>> trials(RowId session) override;
  [[nodiscard]] Result<std::vector<Measure>> measures(RowId trial) override;
  [[nodiscard]] Result<std::vector<Measure>> measures_of_all_versions(RowId trial) override;
  [[nodiscard]] Result<std::vector<EventRecord>> events(RowId session) override;
  [[nodiscard]] Result<std::vector<PreparationRecord>> preparations(RowId session) override;
  [[nodiscard]] Result<std::optional<PreparationRecord>> last_preparation(
      const SessionRecord& session, const std::string& kind) override;
  [[nodiscard]] Result<std::vector<RatingRecord>> ratings(RowId session) override;
  [[nodiscard]] Result<Signals> signals(const TrialRecord& trial) override;
  [[nodiscard]] Result<std::vector<MeasurePoint>> progress(RowId patient) override;

  [[nodiscard]] Result<std::vector<Text>> check() override;
  [[nodiscard]] Result<void> backup(const std::string& to) override;

  /// Marks trials that nobody records any more as interrupted, and packs them; but those whose row
  /// is not what its seal says.
  [[nodiscard]] Result<void> repair();
  /// Closed trials whose signals are in blocks of a second.
  [[nodiscard]] Result<std::vector<RowId>> unpacked();
  /// Puts the blocks of a closed trial together, in one transaction; if it fails they stay. Refused
  /// where the row of the trial is not what its seal says: it would get a new one.
  [[nodiscard]] Result<void> pack_trial(RowId trial);
  /// The same; why it failed becomes an event of the session.
  void pack_or_note(RowId trial);
  /// The hash that packing would give a closed trial; nothing: it is packed.
  [[nodiscard]] Result<std::optional<ContentHash>> hash_of_blocks(RowId trial);

  // For stores that wrap this one.
  [[nodiscard]] Database& database() noexcept { return database_; }
  /// backup(); `prove` tells what else is wrong with the copy before it gets its name.
  using Proof = std::function<Result<std::vector<Text>>(Database& copy)>;
  [[nodiscard]] Result<void> copy_if_sound(const std::string& to, const Proof& prove);
  /// check(), where what is known of people is read through `door`, which may open what is sealed.
  [[nodiscard]] Result<std::vector<Text>> check_through(SessionStore& door);
  struct Added {
    int results = 0;
    int trials = 0;
  };
  /// add_newer_measures(); `before_commit` gets what was added, as a part of the transaction.
  [[nodiscard]] Result<bool> insert_newer_measures(
      RowId patient, std::span<const ScoredTrial> trials,
      const std::function<void(const Added&)>& before_commit);

 private:
  /// The trial that this store records now.
  struct Recording {
    RowId trial = 0;
    std::vector<std::size_t> column_counts;  ///< per group
    double rate_Hz = 0.0;
    int next_second = 0;
    bool short_block_seen = false;
    RecordingLock lock;  ///< held until the trial is closed
  };
  /// Inside a transaction: throws a refusal if others no longer see that this store records.
  void require_lock() const;
  struct BlockInsert;  ///< the prepared statement of append_blocks and its variables

  [[nodiscard]] Result<void> check_blocks(int second,
                                          std::span<const std::vector<double>> rows) const;
  /// Of a trial, in order. Throws.
  [[nodiscard]] std::vector<SignalGroup> groups_of(RowId trial);
  [[nodiscard]] Refusal damaged(const TrialRecord& trial, const Text& where,
                                const Text& what) const;
  /// Rows that a trial of these columns may have (kMostTrialValues). Throws a refusal if it says
  /// that it has more.
  [[nodiscard]] std::size_t most_rows(const TrialRecord& trial) const;
  /// Appends the blocks of a group from second `from` on, at most `most` and until the trial's
  /// samples are there; how many blocks. Throws a refusal that names what is missing or damaged.
  int read_blocks(const TrialRecord& trial, std::size_t group, int from, int most,
                  std::span<std::vector<double>> columns);
  /// The same of packs, and what they say to the hash of the trial; the last one may hold more.
  void read_packs(const TrialRecord& trial, std::size_t group,
                  std::span<std::vector<double>> columns, ContentHasher& whole);
  using PartWork =
      std::function<void(int part, std::size_t rows, const Planes&, const ContentHash& values)>;
  /// The blocks of a group as the parts that packing makes of them, and what they say to the hash
  /// of the trial. Throws a refusal that names what is missing or damaged.
  void read_parts(const TrialRecord& trial, std::size_t group, ContentHasher& whole,
                  const PartWork& work);
  void pack_group(const TrialRecord& trial, std::size_t group, ContentHasher& whole);
  /// What packing needs of a trial; nothing: it is packed, runs or does not exist.
  [[nodiscard]] std::optional<TrialRecord> unpacked_trial(RowId id);
  /// Does a row say what this program wrote? True where there are no seals. Throws.
  [[nodiscard]] bool is_as_sealed(const char* table, RowId row);
  /// Throws a refusal if the table has no such row; `one`: what a row is called.
  void require(const char* table, Words one, RowId id);
  /// A new one; in a scratch file that of `name`: what is made of simulated people for a moment is
  /// the same each time.
  [[nodiscard]] std::string new_uuid(const std::string& name) const;
  /// Inside a transaction.
  void insert_measures(RowId trial, std::span<const Measure> measures);
  void insert_answers(RowId session, std::span<const SessionAnswer> answers);
  /// `where` stands behind FROM sessions.
  [[nodiscard]] std::vector<SessionRecord> read_sessions(const std::string& where);
  /// Those of a session, trial or preparation (`owner`).
  [[nodiscard]] References references_of(const char* owner, RowId id);
  void write_shoulder_pain(const RatingRecord& rating);
  /// Those that are there already stay.
  void insert_references(const char* owner, RowId id, const References& references);
  [[nodiscard]] std::vector<SensorRecord> sensors_of(RowId session);
  /// All; or the one with this code.
  [[nodiscard]] std::vector<PatientRecord> read_patients(const std::string& code);
  /// What the trials of a session rested on, and how that has drifted since.
  void add_preparations_of(RowId session, std::vector<TrialRecord>& trials);
  /// `people` gives patient_id and id of the period as p, joined to sessions s.
  [[nodiscard]] Result<std::vector<PooledValue>> pooled_values(const PoolQuery& query,
                                                               const std::string& people);
  /// `where` stands behind FROM preparations.
  [[nodiscard]] std::vector<PreparationRecord> read_preparations(const std::string& where);

  Database database_;
  std::optional<Recording> recording_;
  std::unique_ptr<BlockInsert> block_insert_;
};

/// Leaves of each measure (name, channel, unit) the newest version, at the place of the first, and
/// says of those that were computed again that they were. Not more than a trial has: their square.
void keep_newest(std::vector<Measure>& measures);

/// Adds what makes no sense in what is known of people, as `store` reads it.
[[nodiscard]] Result<void> check_told(SessionStore& store, std::vector<Text>& problems);

/// Of a packed block. One minute would save another 2 % of room, but damage would then destroy a
/// minute.
inline constexpr int kSecondsPerPart = 10;

/// The part of a trial's hash that says what its columns are.
void add_group(const SignalGroup& group, ContentHasher& whole);

/// Text of the measured delay of the patient's screen in a session, as somebody answered last;
/// empty if nobody did. `session`: an expression for its id.
[[nodiscard]] std::string display_delay_query(const std::string& session);
/// Nothing: not measured.
[[nodiscard]] std::optional<double> display_delay_from(const std::string& answer);

/// Of the row that was inserted last.
[[nodiscard]] RowId last_id(soci::session& sql, const char* table);

}  // namespace isograsp::storage
