// SPDX-License-Identifier: GPL-3.0-or-later
// The guard around a session store, as open_store() gives it: seals free text where the database is
// protected, logs every act in its own transaction, refuses to change or show records of restricted
// and erased people. Inside storage/ only.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "storage/access/audit_log.hpp"
#include "storage/access/login.hpp"
#include "storage/access/sealed_text.hpp"
#include "storage/records/forwarding_store.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace isograsp::storage {

class GuardedStore final : public ForwardingStore<SqliteStore> {
 public:
  GuardedStore(std::unique_ptr<SqliteStore> store, std::shared_ptr<LoginState> state);

  [[nodiscard]] Result<PatientRecord> add_patient(const std::string& code,
                                                  const std::string& created_utc,
                                                  const std::string& uuid) override;
  [[nodiscard]] Result<void> remove_patient(RowId patient) override;
  [[nodiscard]] Result<EventRecord> as_stored(const EventPlace& place,
                                              const EventRecord& event) override;
  [[nodiscard]] Result<RowId> begin_session(const SessionRecord& session,
                                            std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<void> add_answers(RowId session,
                                         std::span<const SessionAnswer> answers) override;
  [[nodiscard]] Result<RowId> add_preparation(const PreparationRecord& preparation) override;
  [[nodiscard]] Result<RowId> begin_trial(const TrialRecord& trial) override;
  [[nodiscard]] Result<RowId> add_rating(const RatingRecord& rating) override;
  [[nodiscard]] Result<void> correct_rating(const RatingRecord& rating) override;
  [[nodiscard]] Result<void> mark_helped(RowId trial, bool helped) override;
  [[nodiscard]] Result<bool> add_newer_measures(RowId patient,
                                                std::span<const ScoredTrial> trials) override;
  // The functions that follow do not ask who is logged in, so that a running recording can be
  // finished whoever logs in meanwhile; nor do append_blocks() and end_trial().
  [[nodiscard]] Result<void> end_session(RowId session, const std::string& ended_utc) override;
  [[nodiscard]] Result<void> add_event(RowId session, const EventRecord& event) override;
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

  [[nodiscard]] Result<PatientProfile> profile(RowId patient) override;
  [[nodiscard]] Result<std::vector<TreatmentMark>> treatment_marks(RowId patient) override;
  [[nodiscard]] Result<std::vector<ClinicalScore>> clinical_scores(RowId patient) override;
  [[nodiscard]] Result<std::vector<PrimaryMeasure>> primary_measures(RowId patient) override;
  [[nodiscard]] Result<std::vector<StablePeriod>> stable_periods(RowId patient) override;
  [[nodiscard]] Result<std::vector<EventRecord>> events(RowId session) override;

  [[nodiscard]] Result<std::vector<Text>> check() override;
  [[nodiscard]] Result<void> backup(const std::string& to) override;

 private:
  [[nodiscard]] Database& database() noexcept { return behind().database(); }
  /// Of the user who is logged in now, who may be another one than when the store was opened. A
  /// lock is ignored: a session goes on while the windows are locked.
  [[nodiscard]] Result<void> may_write() const;
  /// may_write(), then `work`, with its entry.
  template <class Work>
  auto logged(const char* act, const std::string& object, std::string detail, Work work,
              const std::function<void(AuditEntry&)>& complete = {}) -> decltype(work());
  /// One row of what is known of a person removed.
  template <class Work>
  [[nodiscard]] Result<void> removed(const char* table, const char* what, RowId id, Work work);
  /// `query` gives one text; empty if there is none.
  [[nodiscard]] std::string query_text(const std::string& query, RowId id);
  [[nodiscard]] std::string code_of(RowId patient);
  [[nodiscard]] std::string code_of_session(RowId session);
  [[nodiscard]] EventPlace place_of(RowId session, const EventRecord& event);
  // In place, where the database is protected.
  [[nodiscard]] Result<void> close(std::string& text, const TextPlace& place);
  [[nodiscard]] Result<void> open(std::string& text, const TextPlace& place);

  std::shared_ptr<LoginState> state_;
};

/// Who is logged in at a file that is opened. Refused where a login is needed and is not there, or
/// has no right to write.
[[nodiscard]] Result<std::shared_ptr<LoginState>> login_at(Database& database, bool writable);

}  // namespace isograsp::storage
