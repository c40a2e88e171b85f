// SPDX-License-Identifier: GPL-3.0-or-later
// One file taken into another.
#include <gtest/gtest.h>

#include "tests/storage/examples.hpp"

namespace isograsp {
namespace {

/// A file with one patient: two sessions of two trials each, the signals seeded by `seed`.
void make_clinic(const std::string& path, const std::string& code, unsigned seed) {
  const auto store = open_store(path);
  const RowId patient = must(store->add_patient(code, "2026-01-01T00:00:00Z")).id;
  must(store->set_profile(
      patient, {Side::left, Hand::right, "2025-11-01", "notes of " + code, "goals of " + code}));
  must(store->add_treatment_mark(patient, {0, "2026-02-01", "drug", code}));
  must(store->add_clinical_score(patient, {0, "2026-02-02", "ARAT", seed + 0.5, code}));
  for (int s = 0; s < 2; ++s) {
    const RowId session = must(store->begin_session(
        example_session(patient), std::vector<SessionAnswer>{{"screening", "who", code}}));
    InstrumentZeroRecord zero;
    zero.session_id = session;
    zero.mean.fill(Vec6::Constant(seed));
    zero.sd.fill(Vec6::Constant(0.1));
    const RowId zero_id = must(store->add_zero(zero));
    for (int t = 1; t <= 2; ++t) {
      TrialRecord trial = example_trial(session, t);
      trial.zero_id = zero_id;
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 50, seed + t)));
      trial.status = TrialStatus::completed;
      trial.samples = 50;
      Measure measure;
      measure.name = "rmse";
      measure.value = seed + 0.5 * t;
      must(store->end_trial(trial, std::vector{measure}));
      must(store->add_event(session, {trial.id, 1.0, "note", code}));
    }
    must(store->end_session(session, "2026-01-01T01:00:00Z"));
  }
}

/// All that is known of a patient, as text, without the numbers of rows.
std::string told_of(SessionStore& store, const std::string& code) {
  std::string text;
  const auto patient = must(store.find_patient(code));
  const auto profile = must(store.profile(patient->id));
  text += profile.onset_date + profile.notes + profile.goals;
  for (const auto& mark : must(store.treatment_marks(patient->id)))
    text += mark.on_date + mark.kind + mark.text;
  for (const auto& score : must(store.clinical_scores(patient->id)))
    text += score.on_date + score.scale + std::to_string(score.value) + score.text;
  for (const auto& session : must(store.sessions(patient->id))) {
    text += session.started_utc + session.ended_utc + session.device_uri;
    for (const auto& answer : must(store.answers(session.id)))
      text += answer.topic + answer.item + answer.value;
    for (const auto& zero : must(store.zeros(session.id)))
      text += " zero " + std::to_string(zero.mean[0][0]);
    for (const auto& event : must(store.events(session.id)))
      text += " " + event.kind + event.text + (event.trial_id != 0 ? " of a trial" : "");
    const auto trials = must(store.trials(session.id));
    for (const auto& trial : trials) {
      text += " trial " + std::to_string(trial.number) + trial.task_text;
      EXPECT_EQ(trial.zero_id, must(store.zeros(session.id)).front().id);
      for (const auto& measure : must(store.measures(trial.id)))
        text += " " + measure.name + std::to_string(*measure.value);
      const Signals signals = must(store.signals(trial));
      for (const auto& name : signals.names())
        for (const double value : signals.column(name)) text += " " + std::to_string(value);
    }
  }
  return text;
}

TEST(Absorb, WhatAnotherFileHoldsIsHereUnchangedBesideWhatWasHere) {
  const TemporaryFolder folder;
  make_clinic(folder.file("a.db"), "A-1", 10);
  make_clinic(folder.file("b.db"), "B-1", 20);
  const std::string a = told_of(*open_store(folder.file("a.db")), "A-1");
  const std::string b = told_of(*open_store(folder.file("b.db")), "B-1");
  EXPECT_NE(a, b);
  const auto all = open_store(folder.file("a.db"));
  must(all->absorb(folder.file("b.db")));
  EXPECT_EQ(told_of(*all, "A-1"), a);
  EXPECT_EQ(told_of(*all, "B-1"), b);
  EXPECT_TRUE(must(all->check()).empty());
  EXPECT_EQ(told_of(*open_store(folder.file("b.db")), "B-1"), b) << "the other file stays";
  EXPECT_EQ(must(all->patients()).size(), 2u);
  must(all->add_patient("C-1"));  // and the file goes on as before
}

TEST(Absorb, APatientInBothFilesIsRefusedAndNothingIsAdded) {
  const TemporaryFolder folder;
  make_clinic(folder.file("a.db"), "A-1", 10);
  make_clinic(folder.file("b.db"), "A-1", 20);
  const auto all = open_store(folder.file("a.db"));
  const std::string before = told_of(*all, "A-1");
  const auto refused = all->absorb(folder.file("b.db"));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("A-1"), std::string::npos) << refused.error().what;
  EXPECT_EQ(told_of(*all, "A-1"), before);
  EXPECT_EQ(must(all->patients()).size(), 1u);
}

}  // namespace
}  // namespace isograsp
