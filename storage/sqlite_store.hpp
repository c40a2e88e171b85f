// SPDX-License-Identifier: GPL-3.0-or-later
// The session store on SQLite. Internal to this folder; open one with SessionStore::open().
// Writing is in session_store.cpp and absorb.cpp, reading in read_records.cpp and read_signals.cpp,
// both for what is known of a person in profile_records.cpp, care in maintenance.cpp and
// migration.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "storage/database.hpp"
#include "storage/session_store.hpp"

namespace isograsp {

class SqliteStore final : public SessionStore {
 public:
  explicit SqliteStore(Database database);
  ~SqliteStore() override;

  [[nodiscard]] const std::string& path() const noexcept override { return database_.path(); }

  [[nodiscard]] Result<PatientRecord> add_patient(const std::string& code,
                                                  const std::string& created_utc) override;
  [[nodiscard]] Result<RowId> begin_session(const SessionRecord& session,
                                            std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<void> add_answers(RowId session,
                                         std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<void> end_session(RowId session, const std::string& ended_utc) override;
  [[nodiscard]] Result<RowId> add_zero(const InstrumentZeroRecord& zero) override;
  [[nodiscard]] Result<RowId> add_resting_force(const RestingForceRecord& rest) override;
  [[nodiscard]] Result<RowId> begin_trial(const TrialRecord& trial) override;
  [[nodiscard]] Result<void> append_blocks(RowId trial, int second,
                                           std::span<const std::vector<double>> rows) override;
  [[nodiscard]] Result<void> end_trial(const TrialRecord& end,
                                       std::span<const Measure> measures) override;
  [[nodiscard]] Result<void> add_event(RowId session, const EventRecord& event) override;
  [[nodiscard]] Result<RowId> add_rating(const RatingRecord& rating) override;
  [[nodiscard]] Result<void> mark_helped(RowId trial, bool helped) override;
  [[nodiscard]] Result<void> set_profile(RowId patient, const PatientProfile& profile) override;
  [[nodiscard]] Result<RowId> add_treatment_mark(RowId patient, const TreatmentMark& mark) override;
  [[nodiscard]] Result<void> remove_treatment_mark(RowId id) override;
  [[nodiscard]] Result<RowId> add_clinical_score(RowId patient,
                                                 const ClinicalScore& score) override;
  [[nodiscard]] Result<void> remove_clinical_score(RowId id) override;

  [[nodiscard]] Result<std::vector<PatientRecord>> patients() override;
  [[nodiscard]] Result<std::optional<PatientRecord>> find_patient(const std::string& code) override;
  [[nodiscard]] Result<PatientProfile> profile(RowId patient) override;
  [[nodiscard]] Result<std::vector<TreatmentMark>> treatment_marks(RowId patient) override;
  [[nodiscard]] Result<std::vector<ClinicalScore>> clinical_scores(RowId patient) override;
  [[nodiscard]] Result<std::vector<SessionRecord>> sessions(RowId patient) override;
  [[nodiscard]] Result<std::vector<SessionRecord>> recent_sessions(int most) override;
  [[nodiscard]] Result<std::vector<SessionAnswer>> answers(RowId session) override;
  [[nodiscard]] Result<std::vector<TrialRecord>> trials(RowId session) override;
  [[nodiscard]] Result<std::vector<Measure>> measures(RowId trial) override;
  [[nodiscard]] Result<std::vector<EventRecord>> events(RowId session) override;
  [[nodiscard]] Result<std::vector<InstrumentZeroRecord>> zeros(RowId session) override;
  [[nodiscard]] Result<std::optional<InstrumentZeroRecord>> last_zero(
      const SessionRecord& session) override;
  [[nodiscard]] Result<std::vector<RestingForceRecord>> resting_forces(RowId session) override;
  [[nodiscard]] Result<std::vector<RatingRecord>> ratings(RowId session) override;
  [[nodiscard]] Result<Signals> signals(const TrialRecord& trial) override;
  [[nodiscard]] Result<std::vector<MeasurePoint>> progress(RowId patient) override;

  [[nodiscard]] Result<void> absorb(const std::string& other) override;
  [[nodiscard]] Result<std::vector<std::string>> check() override;
  [[nodiscard]] Result<void> backup(const std::string& to) override;

  /// Marks trials that nobody records any more as interrupted.
  [[nodiscard]] Result<void> repair();

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
  struct BlockInsert;  ///< the prepared statement of append_blocks and its variables

  [[nodiscard]] Error refuse(std::string what, std::string remedy) const;
  [[nodiscard]] Result<void> check_blocks(int second,
                                          std::span<const std::vector<double>> rows) const;
  void read_groups(TrialRecord& trial);
  /// Throws a refusal if the table has no such row; `one`: what a row is called.
  void require(const char* table, const char* one, RowId id);
  void insert_answers(RowId session, std::span<const SessionAnswer> answers);
  /// Adds what makes no sense in what is known of persons.
  [[nodiscard]] Result<void> check_told(std::vector<std::string>& problems);
  /// `where` stands behind FROM sessions.
  [[nodiscard]] std::vector<SessionRecord> read_sessions(const std::string& where);
  /// `expression` where the file has the columns of that format, else `instead`.
  [[nodiscard]] std::string since(int format, const char* expression, const char* instead) const;
  /// `where` stands behind FROM instrument_zeros z JOIN sessions s.
  [[nodiscard]] std::vector<InstrumentZeroRecord> read_zeros(const std::string& where);

  Database database_;
  std::optional<Recording> recording_;
  std::unique_ptr<BlockInsert> block_insert_;
};

/// Of the row that was inserted last.
[[nodiscard]] RowId last_id(soci::session& sql, const char* table);

/// One a line: thumb, index, middle. Empty if no sensor told its own.
[[nodiscard]] std::string serials_text(const std::array<std::string, kFingerCount>& serials);

}  // namespace isograsp
