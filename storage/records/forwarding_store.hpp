// SPDX-License-Identifier: GPL-3.0-or-later
// Inside storage/ only: a store that hands every call to another one: base of stores that change
// some calls.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "storage/records/session_store.hpp"

namespace isograsp::storage {

template <class Store>
class ForwardingStore : public SessionStore {
 public:
  explicit ForwardingStore(std::unique_ptr<Store> store) : store_(std::move(store)) {}

  [[nodiscard]] const std::string& path() const noexcept override { return store_->path(); }
  [[nodiscard]] Result<void> in_place() override { return store_->in_place(); }
  [[nodiscard]] bool is_last_hold() override { return store_->is_last_hold(); }
  [[nodiscard]] Result<void> save_copy(const std::string& to) override {
    return store_->save_copy(to);
  }
  [[nodiscard]] Result<EventRecord> as_stored(const EventPlace& place,
                                              const EventRecord& event) override {
    return store_->as_stored(place, event);
  }
  [[nodiscard]] Result<std::string> database_id() override { return store_->database_id(); }
  [[nodiscard]] Result<PatientRecord> add_patient(const std::string& code,
                                                  const std::string& created_utc,
                                                  const std::string& uuid) override {
    return store_->add_patient(code, created_utc, uuid);
  }
  [[nodiscard]] Result<void> remove_patient(RowId patient) override {
    return store_->remove_patient(patient);
  }
  [[nodiscard]] Result<RowId> begin_session(const SessionRecord& session,
                                            std::span<const SessionAnswer> answers) override {
    return store_->begin_session(session, answers);
  }
  [[nodiscard]] Result<void> add_answers(RowId session,
                                         std::span<const SessionAnswer> answers) override {
    return store_->add_answers(session, answers);
  }
  [[nodiscard]] Result<void> end_session(RowId session, const std::string& ended_utc) override {
    return store_->end_session(session, ended_utc);
  }
  [[nodiscard]] Result<RowId> add_preparation(const PreparationRecord& preparation) override {
    return store_->add_preparation(preparation);
  }
  [[nodiscard]] Result<RowId> begin_trial(const TrialRecord& trial) override {
    return store_->begin_trial(trial);
  }
  [[nodiscard]] Result<void> append_blocks(RowId trial, int second,
                                           std::span<const std::vector<double>> rows) override {
    return store_->append_blocks(trial, second, rows);
  }
  [[nodiscard]] Result<void> end_trial(const TrialRecord& end,
                                       std::span<const Measure> measures) override {
    return store_->end_trial(end, measures);
  }
  [[nodiscard]] Result<bool> add_newer_measures(RowId patient,
                                                std::span<const ScoredTrial> trials) override {
    return store_->add_newer_measures(patient, trials);
  }
  [[nodiscard]] Result<void> add_event(RowId session, const EventRecord& event) override {
    return store_->add_event(session, event);
  }
  [[nodiscard]] Result<RowId> add_rating(const RatingRecord& rating) override {
    return store_->add_rating(rating);
  }
  [[nodiscard]] Result<void> correct_rating(const RatingRecord& rating) override {
    return store_->correct_rating(rating);
  }
  [[nodiscard]] Result<void> mark_helped(RowId trial, bool helped) override {
    return store_->mark_helped(trial, helped);
  }
  [[nodiscard]] Result<void> set_profile(RowId patient, const PatientProfile& profile) override {
    return store_->set_profile(patient, profile);
  }
  [[nodiscard]] Result<RowId> add_treatment_mark(RowId patient,
                                                 const TreatmentMark& mark) override {
    return store_->add_treatment_mark(patient, mark);
  }
  [[nodiscard]] Result<void> remove_treatment_mark(RowId id) override {
    return store_->remove_treatment_mark(id);
  }
  [[nodiscard]] Result<RowId> add_clinical_score(RowId patient,
                                                 const ClinicalScore& score) override {
    return store_->add_clinical_score(patient, score);
  }
  [[nodiscard]] Result<void> remove_clinical_score(RowId id) override {
    return store_->remove_clinical_score(id);
  }
  [[nodiscard]] Result<RowId> add_primary_measure(RowId patient,
                                                  const PrimaryMeasure& primary) override {
    return store_->add_primary_measure(patient, primary);
  }
  [[nodiscard]] Result<void> remove_primary_measure(RowId id) override {
    return store_->remove_primary_measure(id);
  }
  [[nodiscard]] Result<RowId> add_stable_period(RowId patient,
                                                const StablePeriod& period) override {
    return store_->add_stable_period(patient, period);
  }
  [[nodiscard]] Result<void> remove_stable_period(RowId id) override {
    return store_->remove_stable_period(id);
  }
  [[nodiscard]] Result<std::vector<PatientRecord>> patients() override {
    return store_->patients();
  }
  [[nodiscard]] Result<std::optional<PatientRecord>> find_patient(
      const std::string& code) override {
    return store_->find_patient(code);
  }
  [[nodiscard]] Result<PatientProfile> profile(RowId patient) override {
    return store_->profile(patient);
  }
  [[nodiscard]] Result<std::vector<TreatmentMark>> treatment_marks(RowId patient) override {
    return store_->treatment_marks(patient);
  }
  [[nodiscard]] Result<std::vector<ClinicalScore>> clinical_scores(RowId patient) override {
    return store_->clinical_scores(patient);
  }
  [[nodiscard]] Result<std::vector<PrimaryMeasure>> primary_measures(RowId patient) override {
    return store_->primary_measures(patient);
  }
  [[nodiscard]] Result<std::vector<StablePeriod>> stable_periods(RowId patient) override {
    return store_->stable_periods(patient);
  }
  [[nodiscard]] Result<std::vector<PooledValue>> stable_values(const PoolQuery& query) override {
    return store_->stable_values(query);
  }
  [[nodiscard]] Result<std::vector<PooledValue>> healthy_values(const PoolQuery& query) override {
    return store_->healthy_values(query);
  }
  [[nodiscard]] Result<bool> may_be_used_for_research(RowId patient) override {
    return store_->may_be_used_for_research(patient);
  }
  [[nodiscard]] Result<std::string> consent_state(RowId patient,
                                                  const std::string& purpose) override {
    return store_->consent_state(patient, purpose);
  }
  [[nodiscard]] Result<std::vector<SessionRecord>> sessions(RowId patient) override {
    return store_->sessions(patient);
  }
  [[nodiscard]] Result<std::vector<SessionRecord>> recent_sessions(int most) override {
    return store_->recent_sessions(most);
  }
  [[nodiscard]] Result<std::vector<SessionAnswer>> answers(RowId session) override {
    return store_->answers(session);
  }
  [[nodiscard]] Result<std::vector<TrialRecord>> trials(RowId session) override {
    return store_->trials(session);
  }
  [[nodiscard]] Result<std::vector<Measure>> measures(RowId trial) override {
    return store_->measures(trial);
  }
  [[nodiscard]] Result<std::vector<Measure>> measures_of_all_versions(RowId trial) override {
    return store_->measures_of_all_versions(trial);
  }
  [[nodiscard]] Result<std::vector<EventRecord>> events(RowId session) override {
    return store_->events(session);
  }
  [[nodiscard]] Result<std::vector<PreparationRecord>> preparations(RowId session) override {
    return store_->preparations(session);
  }
  [[nodiscard]] Result<std::optional<PreparationRecord>> last_preparation(
      const SessionRecord& session, const std::string& kind) override {
    return store_->last_preparation(session, kind);
  }
  [[nodiscard]] Result<std::vector<RatingRecord>> ratings(RowId session) override {
    return store_->ratings(session);
  }
  [[nodiscard]] Result<Signals> signals(const TrialRecord& trial) override {
    return store_->signals(trial);
  }
  [[nodiscard]] Result<std::vector<MeasurePoint>> progress(RowId patient) override {
    return store_->progress(patient);
  }
  [[nodiscard]] Result<std::vector<Text>> check() override { return store_->check(); }
  [[nodiscard]] Result<void> backup(const std::string& to) override { return store_->backup(to); }

 protected:
  [[nodiscard]] Store& behind() noexcept { return *store_; }

 private:
  std::unique_ptr<Store> store_;
};

}  // namespace isograsp::storage
