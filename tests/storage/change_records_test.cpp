// SPDX-License-Identifier: GPL-3.0-or-later
// Primary measures and times judged stable: who, when, how many; and which values may be pooled.
#include <algorithm>
#include <ctime>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/time.hpp"
#include "tests/storage/one_patient.hpp"

namespace isograsp::storage::change_records_test {
namespace {

struct ChangeRecords : OnePatient {};

PrimaryMeasure primary(const std::string& channel) {
  return {0,       "Maximum grip",         Hand::left,   "maximum_force",
          channel, "2026-03-05T10:00:00Z", "Therapist 7"};
}
StablePeriod period(const std::string& from, const std::string& until) {
  return {0, from, until, "2026-04-01T10:00:00Z", "Therapist 7", "no change of treatment"};
}

TEST_F(ChangeRecords, PrimaryMeasuresComeBackWithWhoAndWhenAndCanBeRemoved) {
  auto grip = primary("grip");
  auto thumb = primary("thumb");
  thumb.chosen_utc = "2026-03-04T10:00:00Z";
  grip.id = must(store->add_primary_measure(patient, grip));
  thumb.id = must(store->add_primary_measure(patient, thumb));
  reopen();
  EXPECT_EQ(must(store->primary_measures(patient)), (std::vector{thumb, grip}));
  must(store->remove_primary_measure(thumb.id));
  EXPECT_FALSE(store->remove_primary_measure(thumb.id).ok()) << "it is gone";
  EXPECT_EQ(must(store->primary_measures(patient)), std::vector{grip});
  auto now = primary("index");
  now.chosen_utc.clear();
  const std::string before = utc_text(std::time(nullptr));
  must(store->add_primary_measure(patient, now));
  const auto all = must(store->primary_measures(patient));
  const auto added =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.channel == "index"; });
  ASSERT_NE(added, all.end());
  EXPECT_GE(added->chosen_utc, before);
  EXPECT_LE(added->chosen_utc, utc_text(std::time(nullptr)));
}

TEST_F(ChangeRecords, AFifthPrimaryMeasureAndOneThatIsThereAreRefused) {
  for (const char* channel : {"grip", "thumb", "index"})
    must(store->add_primary_measure(patient, primary(channel)));
  const auto same = store->add_primary_measure(patient, primary("grip"));
  ASSERT_FALSE(same.ok());
  EXPECT_NE(english(same.error().what).find("maximum_force"), std::string::npos);
  auto other_hand = primary("grip");
  other_hand.hand = Hand::right;
  must(store->add_primary_measure(patient, other_hand));
  const auto fifth = store->add_primary_measure(patient, primary("middle"));
  ASSERT_FALSE(fifth.ok());
  EXPECT_NE(english(fifth.error().what).find("4"), std::string::npos)
      << english(fifth.error().what);
  EXPECT_EQ(must(store->primary_measures(patient)).size(), 4u);
  must(store->add_primary_measure(must(store->add_patient("P-2")).id, primary("middle")));
}

TEST_F(ChangeRecords, StableTimesComeBackByDateAndCanBeRemoved) {
  auto later = period("2026-03-05", "2026-03-20");
  auto earlier = period("2026-01-05", "2026-01-05");
  later.id = must(store->add_stable_period(patient, later));
  earlier.id = must(store->add_stable_period(patient, earlier));
  reopen();
  EXPECT_EQ(must(store->stable_periods(patient)), (std::vector{earlier, later}));
  must(store->remove_stable_period(earlier.id));
  EXPECT_FALSE(store->remove_stable_period(earlier.id).ok()) << "it is gone";
  EXPECT_EQ(must(store->stable_periods(patient)), std::vector{later});
}

TEST_F(ChangeRecords, WhatMakesNoSenseIsRefusedByTheNameOfItsField) {
  const auto field_of = [&](const StablePeriod& wrong) {
    const auto refused = store->add_stable_period(patient, wrong);
    return refused.ok() ? "" : refused.error().field;
  };
  EXPECT_EQ(field_of(period("2026-02-30", "2026-03-01")), "from_date");
  EXPECT_EQ(field_of(period("2026-02-01", "tomorrow")), "until_date");
  EXPECT_EQ(field_of(period("2026-02-02", "2026-02-01")), "until_date");
  auto nobody = period("2026-02-01", "2026-02-02");
  nobody.judged_by.clear();
  EXPECT_EQ(field_of(nobody), "judged_by");
  auto unsaid = primary("grip");
  unsaid.chosen_by.clear();
  EXPECT_EQ(store->add_primary_measure(patient, unsaid).error().field, "chosen_by");
  EXPECT_FALSE(store->add_primary_measure(patient + 1, primary("grip")).ok()) << "nobody";
  EXPECT_FALSE(store->add_stable_period(patient + 1, period("2026-02-01", "2026-02-02")).ok());
  must(store->add_stable_period(patient, period("2026-03-05", "2026-03-20")));
  for (const auto& [from, until] : {std::pair{"2026-03-20", "2026-03-25"},
                                    {"2026-03-01", "2026-03-05"},
                                    {"2026-03-07", "2026-03-08"}}) {
    const auto refused = store->add_stable_period(patient, period(from, until));
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(english(refused.error().what).find("2026-03-05"), std::string::npos);
  }
  must(store->add_stable_period(patient, period("2026-03-21", "2026-03-25")));
  EXPECT_EQ(must(store->stable_periods(patient)).size(), 2u);
}

TEST_F(ChangeRecords, WhatAnotherProgramWroteWronglyIsRefusedByTheTablesOrFoundByTheCheck) {
  must(store->add_stable_period(patient, period("2026-03-05", "2026-03-20")));
  must(store->add_stable_period(patient, period("2026-04-05", "2026-04-20")));
  must(store->add_primary_measure(patient, primary("grip")));
  EXPECT_TRUE(must(store->check()).empty());
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  for (const char* wrong :
       {"UPDATE stable_periods SET until_date = '2026-02-01'",
        "UPDATE stable_periods SET from_date = '2026-02-30'",
        "UPDATE stable_periods SET judged_by = ''", "UPDATE primary_measures SET chosen_by = ''",
        "UPDATE primary_measures SET hand = 'neither'"})
    EXPECT_THROW(sql << wrong, soci::soci_error) << wrong;
  sql << "UPDATE stable_periods SET until_date = '2026-04-06' WHERE until_date = '2026-03-20'";
  const auto problems = must(store->check());
  ASSERT_EQ(problems.size(), 2u) << "the second: that the row is not what was written";
  EXPECT_NE(english(problems[0]).find("P-0427 overlap on 2026-04-05"), std::string::npos)
      << english(problems[0]);
}

/// A trial with one value of "rmse".
struct Recorded {
  std::string date = "2026-03-05";
  double value = 1.0;
  bool simulated = false;
  bool practice = false;
  bool helped = false;
  int task_version = 3;
  std::string scene = "scene";
  TrialStatus status = TrialStatus::completed;
};
void record(SessionStore& store, RowId patient, const Recorded& what) {
  SessionRecord session = example_session(patient);
  session.started_utc = what.date + "T09:30:00Z";
  session.simulated = what.simulated;
  session.recorded = false;
  const RowId id = must(store.begin_session(session));
  TrialRecord trial = example_trial(id);
  trial.task_version = what.task_version;
  trial.scene_text = what.scene;
  trial.practice = what.practice;
  trial.id = must(store.begin_trial(trial));
  must(store.append_blocks(trial.id, 0, example_rows(trial, 5, 1)));
  trial.status = what.status;
  trial.references["visual_gain_deg_per_N"] = 0.5;
  Measure measure;
  measure.name = "rmse";
  measure.channel = "force";
  measure.unit = "N";
  measure.value = what.value;
  Measure other = measure;
  other.channel = "x";
  must(store.end_trial(trial, std::vector{measure, other}));
  if (what.helped) must(store.mark_helped(trial.id, true));
}
PoolQuery query_of_examples() {
  const TrialRecord like = example_trial(0);
  return {like.task_name, 3, like.task_text, "scene", "rmse", "force", "N", 1, false, false};
}

TEST_F(ChangeRecords, ValuesOfOlderVersionsOfTheMeasureComeWithTheirTrialNewerOnesDoNot) {
  must(store->add_stable_period(patient, period("2026-03-05", "2026-03-20")));
  record(*store, patient, {"2026-03-05", 1.0});
  auto query = query_of_examples();
  query.measure_version = 2;
  const auto values = must(store->stable_values(query));
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].measure_version, 1);
  EXPECT_EQ(must(store->trials(values[0].session_id)).at(0).id, values[0].trial_id);
  query.measure_version = 0;
  EXPECT_TRUE(must(store->stable_values(query)).empty());
}

TEST_F(ChangeRecords, OnlyAssessmentsOnStableDaysOfTheSameTaskAndSourceArePooled) {
  const RowId other = must(store->add_patient("P-0428")).id;
  must(store->set_profile(patient, {Side::left, {}, "", "", ""}));
  must(store->add_stable_period(patient, period("2026-03-05", "2026-03-20")));
  must(store->add_stable_period(other, period("2026-03-05", "2026-03-20")));
  record(*store, other, {"2026-03-06", 3.0});
  for (const char* date : {"2026-03-20", "2026-03-05", "2026-03-04", "2026-03-21"})
    record(*store, patient, {date, 1.0});
  Recorded wrong{"2026-03-07", 99.0};
  for (const auto& spoil :
       {+[](Recorded& one) { one.simulated = true; }, +[](Recorded& one) { one.practice = true; },
        +[](Recorded& one) { one.helped = true; }, +[](Recorded& one) { one.task_version = 4; },
        +[](Recorded& one) { one.scene = "another"; },
        +[](Recorded& one) { one.status = TrialStatus::aborted; }}) {
    Recorded spoiled = wrong;
    spoil(spoiled);
    record(*store, patient, spoiled);
  }
  const auto values = must(store->stable_values(query_of_examples()));
  ASSERT_EQ(values.size(), 3u);
  EXPECT_FALSE(values[0].display_delay_s.has_value());
  const RowId session = values[0].session_id;
  must(store->add_answers(
      session, std::vector<SessionAnswer>{{"screen", "display_delay_s", "not measured"}}));
  EXPECT_FALSE(must(store->stable_values(query_of_examples()))[0].display_delay_s.has_value());
  must(store->add_answers(session,
                          std::vector<SessionAnswer>{{"screen", "display_delay_s", "0.0450"}}));
  EXPECT_EQ(must(store->stable_values(query_of_examples()))[0].display_delay_s, 0.045);
  const auto sessions = must(store->sessions(patient));
  const auto answered =
      std::find_if(sessions.begin(), sessions.end(), [&](auto& one) { return one.id == session; });
  ASSERT_NE(answered, sessions.end());
  EXPECT_EQ(answered->display_delay_s, 0.045) << "as answered last";
  EXPECT_EQ(values[0].patient_id, patient);
  EXPECT_EQ(values[0].started_utc, "2026-03-05T09:30:00Z") << "oldest first";
  EXPECT_EQ(values[1].started_utc, "2026-03-20T09:30:00Z") << "the last day belongs to it";
  EXPECT_EQ(values[0].affected, Side::left);
  EXPECT_EQ(values[0].hand, Hand::left);
  EXPECT_EQ(values[0].value, 1.0);
  EXPECT_EQ(values[0].references.at("visual_gain_deg_per_N"), 0.5);
  EXPECT_EQ(values[2].patient_id, other);
  EXPECT_EQ(values[2].value, 3.0);
  EXPECT_FALSE(values[2].affected.has_value());
}

TEST_F(ChangeRecords, HealthyValuesAreThoseOfPeopleWithoutAnAffectedSide) {
  must(store->set_profile(patient, {Side::none, Hand::right, "", "", "", Sex::female, 1961}));
  record(*store, patient, {"2026-03-04", 2.0});
  const RowId affected = must(store->add_patient("P-9")).id;
  must(store->set_profile(affected, {Side::both, Hand::right, "", "", "", Sex::female, 1961}));
  record(*store, affected, {"2026-03-04", 9.0});
  record(*store, must(store->add_patient("P-8")).id, {"2026-03-04", 8.0});
  const auto values = must(store->healthy_values(query_of_examples()));
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[0].value, 2.0);
  EXPECT_EQ(values[0].sex, Sex::female);
  EXPECT_EQ(values[0].birth_year, 1961);
  EXPECT_EQ(values[0].dominant, Hand::right);
  EXPECT_EQ(values[0].period_id, 0);
}

}  // namespace
}  // namespace isograsp::storage::change_records_test
