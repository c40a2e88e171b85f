// SPDX-License-Identifier: GPL-3.0-or-later
// What the patient page knows of a patient: which measures it shows, what it compares, and what
// it makes of a damaged trial.
#include "gui/clinic/patient_course.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "gui/record_pages/measure_trend.hpp"
#include "gui/record_pages/session_comparison.hpp"
#include "gui/trial_pages/opened_trial.hpp"
#include "kinematics/pose_task.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::patient_course_test {
namespace {

using namespace isograsp::test;

class PatientCourseTest : public ::testing::Test {
 protected:
  PatientCourseTest() {
    auto store = storage::open_store(path_, storage::OpenMode::scratch);
    EXPECT_TRUE(store.ok());
    store_ = *std::move(store);
  }
  [[nodiscard]] PatientCourse course() {
    auto course = read_course(*store_, "P-1");
    EXPECT_TRUE(course.ok()) << course.error().message();
    return *std::move(course);
  }
  void execute(const std::string& statement) const {
    soci::session sql(soci::sqlite3, path_);
    sql << statement;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("clinic.db");
  std::unique_ptr<storage::SessionStore> store_;
};

TEST_F(PatientCourseTest, HoldsEverySessionWithItsTrialsAndTheirMeasures) {
  add_course(*store_, "P-1", false);
  const auto all = course();
  ASSERT_EQ(all.sessions.size(), 6U);
  EXPECT_EQ(all.sessions.front().number, 1);
  EXPECT_EQ(all.sessions.front().record.started_utc, "2026-03-02T09:30:00Z");
  ASSERT_EQ(all.sessions.back().trials.size(), 8U);
  const auto& practice = all.sessions.back().trials[3];
  EXPECT_TRUE(practice.record.practice);
  EXPECT_FALSE(is_assessment(practice.record));
  EXPECT_FALSE(practice.measures.empty());
  EXPECT_EQ(all.sessions.back().trials[7].record.status, storage::TrialStatus::aborted);
  EXPECT_FALSE(is_assessment(all.sessions.back().trials[7].record));
  const Measure* key = key_measure(all.sessions.back().trials[4]);
  ASSERT_NE(key, nullptr);
  EXPECT_EQ(key->name, "relative_rmse");
}

TEST_F(PatientCourseTest, NobodyIsAnError) {
  EXPECT_FALSE(read_course(*store_, "P-1").ok());
}

TEST_F(PatientCourseTest, KeyMeasuresComeFirstAndNoneIsForResearchOnly) {
  add_course(*store_, "P-1", false);
  const auto all = course();
  const auto trends = choose_trends(all);
  ASSERT_FALSE(trends.empty());
  EXPECT_TRUE(trends.front().key);
  EXPECT_TRUE(std::is_partitioned(trends.begin(), trends.end(),
                                  [](const MeasureTrend& trend) { return trend.key; }));
  std::set<QString> research;
  for (const auto& point : all.points)
    if (!tasks::words_of(point.measure.name, point.measure.channel).clinical)
      research.insert(QString::fromStdString(point.measure.name));
  EXPECT_LT(trends.size(), 15U) << "a choice, not everything";
}

TEST_F(PatientCourseTest, PracticeAndHelpAreMarkedAndStandInNoMean) {
  const storage::RowId session = add_session(*store_, "P-1", {});
  const auto trials = store_->trials(session);
  ASSERT_TRUE(store_->mark_helped((*trials)[5].id, true).ok());
  const auto trends = choose_trends(course());
  const auto trend = std::find_if(trends.begin(), trends.end(), [](const MeasureTrend& one) {
    return one.title.startsWith("Tracking error");
  });
  ASSERT_NE(trend, trends.end());
  using Kind = MeasureTrend::Kind;
  ASSERT_EQ(trend->points.size(), 3U);
  EXPECT_EQ(trend->points[0].kind, Kind::practised);
  EXPECT_EQ(trend->points[1].kind, Kind::assessed);
  EXPECT_EQ(trend->points[2].kind, Kind::helped);
  ASSERT_EQ(trend->means.size(), 1U);
  EXPECT_EQ(trend->means[0].trials, 1);
  EXPECT_EQ(trend->means[0].value, trend->points[1].value);
}

TEST_F(PatientCourseTest, SimulatedTrialsAreNeverInOneTrendWithMeasuredOnes) {
  add_session(*store_, "P-1", {});
  DemoSession simulated;
  simulated.simulated = true;
  simulated.date = "2026-03-09";
  add_session(*store_, "P-1", simulated);
  int measured = 0;
  int made = 0;
  for (const auto& trend : every(choose_trends(course()))) {
    ++(trend.simulated ? made : measured);
    EXPECT_EQ(trend.task.startsWith("SIMULATED"), trend.simulated);
    for (const auto& point : every(trend.points)) EXPECT_EQ(point.session, trend.simulated ? 2 : 1);
  }
  EXPECT_EQ(measured, made);
  EXPECT_GT(measured, 0);
}

TEST_F(PatientCourseTest, TheDifferenceOfTwoSessionsIsThatOfTheirMeans) {
  add_course(*store_, "P-1", false);
  const auto all = course();
  const auto comparison = compare_sessions(all.sessions[0], all.sessions[4]);
  EXPECT_TRUE(comparison.left_out.empty());
  const auto row = std::find_if(
      comparison.rows.begin(), comparison.rows.end(),
      [](const ComparedMeasure& one) { return one.key && one.title.startsWith("Tracking error"); });
  ASSERT_NE(row, comparison.rows.end());
  const auto mean = [&](const CourseSession& session) {
    double sum = 0.0;
    for (const std::size_t trial : {4U, 5U})
      sum += key_measure(session.trials[trial])->value.value();
    return sum / 2.0;
  };
  EXPECT_EQ(row->a.trials, 2);
  EXPECT_DOUBLE_EQ(row->a.value.value(), mean(all.sessions[0]));
  EXPECT_DOUBLE_EQ(row->difference.value(), mean(all.sessions[4]) - mean(all.sessions[0]));
  const auto back = compare_sessions(all.sessions[4], all.sessions[0]);
  ASSERT_EQ(back.rows.size(), comparison.rows.size());
  AtLeast compared(1);
  for (std::size_t i = 0; i < back.rows.size(); ++i)
    if (back.rows[i].difference) {
      EXPECT_DOUBLE_EQ(*back.rows[i].difference, -*comparison.rows[i].difference);
      ++compared;
    }
}

TEST_F(PatientCourseTest, OnlyLikeIsComparedWithLike) {
  add_session(*store_, "P-1", {});
  DemoSession other;
  other.date = "2026-03-09";
  other.hand = Hand::left;
  add_session(*store_, "P-1", other);
  other = {};
  other.date = "2026-03-10";
  other.simulated = true;
  add_session(*store_, "P-1", other);
  other = {};
  other.date = "2026-03-11";
  other.task_version = 2;
  add_session(*store_, "P-1", other);
  const auto all = course();
  for (const std::size_t unlike : {0U, 1U, 2U}) {
    const auto comparison = compare_sessions(all.sessions[0], all.sessions[unlike]);
    EXPECT_TRUE(comparison.rows.empty()) << unlike;
    EXPECT_EQ(comparison.left_out.size(), 1U) << "and it says why";
  }
  const auto versions = compare_sessions(all.sessions[0], all.sessions[3]);
  for (const auto& row : every(versions.rows))
    EXPECT_NE(row.task.toStdString(), "Maximum grip force");
  EXPECT_TRUE(std::any_of(versions.left_out.begin(), versions.left_out.end(),
                          [](const QString& one) { return one.contains("other version"); }));
}

TEST_F(PatientCourseTest, AnotherVersionOfAMeasureIsNotCompared) {
  add_session(*store_, "P-1", {});
  add_session(*store_, "P-1", {});
  auto all = course();
  const auto before = compare_sessions(all.sessions[0], all.sessions[1]).rows.size();
  for (auto& trial : all.sessions[1].trials)
    for (auto& measure : trial.measures)
      if (measure.name == "relative_rmse") ++measure.version;
  const auto comparison = compare_sessions(all.sessions[0], all.sessions[1]);
  EXPECT_LT(comparison.rows.size(), before);
  ASSERT_EQ(comparison.left_out.size(), 1U);
  EXPECT_TRUE(comparison.left_out[0].contains("other version of the measure"));
}

TEST_F(PatientCourseTest, SessionsOfAnArmAreComparedAlthoughItsReferencesAreThoseOfTheDay) {
  const auto session = [](int number, const std::string& postures, double x_m) {
    PoseTask task;
    task.frame = "object";
    task.postures_hash = postures;
    task.references = {{"turned", {Vec3(x_m, 0.0, 0.0), Quat::Identity()}}};
    task.targets = {0};
    task.position_tolerance_m = task.angle_tolerance_rad = 0.1;
    task.time_limit_s = 10.0;
    CourseTrial trial;
    trial.record.task_name = "Turn";
    trial.record.scene_text = pose_task_text(task);
    trial.record.status = storage::TrialStatus::completed;
    trial.measures = {{"reached_share", "", 1.0, "1", 1, 10, 0, ""}};
    CourseSession one{number, {}, {trial}};
    one.record.id = number;
    return one;
  };
  EXPECT_EQ(compare_sessions(session(1, "0a", 0.1), session(2, "0a", 0.2)).rows.size(), 1U);
  EXPECT_TRUE(compare_sessions(session(1, "0a", 0.1), session(2, "1b", 0.1)).rows.empty());
}

TEST_F(PatientCourseTest, AWaitInVainDoesNotDropOutOfAMean) {
  CourseTrial trial;
  trial.record.status = storage::TrialStatus::completed;
  trial.measures = {{"reaction_time", "", 2.0, "s", 1, 10, 0, ""}};
  ASSERT_TRUE(tasks::words_of("reaction_time", "").censored);
  CourseSession a{1, {}, {trial}};
  CourseSession b{2, {}, {trial, trial}};
  b.record.id = 2;
  b.trials[1].measures[0].value = std::nullopt;
  b.trials[1].measures[0].reason = "the target was not reached";
  const auto comparison = compare_sessions(a, b);
  ASSERT_EQ(comparison.rows.size(), 1U);
  EXPECT_TRUE(comparison.rows[0].a.value.has_value());
  EXPECT_FALSE(comparison.rows[0].b.value.has_value());
  EXPECT_EQ(comparison.rows[0].b.reason, "the target was not reached");
  EXPECT_FALSE(comparison.rows[0].difference.has_value());
}

TEST_F(PatientCourseTest, ADamagedTrialIsReadUpToTheDamage) {
  add_session(*store_, "P-1", {});
  execute("UPDATE signal_packs SET values_blake2b = zeroblob(32) WHERE trial_id = 5 AND part = 1");
  const auto all = course();
  const auto& session = all.sessions[0];
  const auto opened = open_trial(*store_, session.record, session.trials[4].record);
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->signals.rows(), 1000U);
  EXPECT_NE(opened->damage.find("seconds 10 to 19"), std::string::npos) << opened->damage;
  EXPECT_NE(opened->damage.find("first 1000 of 3200"), std::string::npos) << opened->damage;
  EXPECT_FALSE(opened->measures.empty()) << "measures were stored apart";
  const auto sound = open_trial(*store_, session.record, session.trials[5].record);
  EXPECT_EQ(sound->signals.rows(), 3200U);
  EXPECT_TRUE(sound->damage.empty());
}

TEST_F(PatientCourseTest, ADamagedGroupLeavesTheChannelsBeforeIt) {
  const storage::RowId session_id = add_session(*store_, "P-1", {});
  storage::TrialRecord trial;
  trial.session_id = session_id;
  trial.number = 8;
  trial.task_name = "Two groups";
  trial.groups = {{"task", {"t_s", "actual_force_N"}}, {"raw", {"thumb_fx_counts"}}};
  trial.id = *store_->begin_trial(trial);
  std::vector<std::vector<double>> rows(2);
  for (int row = 0; row < 100; ++row) {
    rows[0].insert(rows[0].end(), {0.01 * row, 1.0});
    rows[1].push_back(row);
  }
  ASSERT_TRUE(store_->append_blocks(trial.id, 0, rows).ok());
  trial.samples = 100;
  trial.status = storage::TrialStatus::completed;
  ASSERT_TRUE(store_->end_trial(trial, {}).ok());
  execute(
      "UPDATE signal_packs SET values_blake2b = zeroblob(32) WHERE position = 1 AND trial_id = " +
      std::to_string(trial.id));
  const auto all = course();
  const auto& session = all.sessions[0];
  const auto opened = open_trial(*store_, session.record, session.trials.back().record);
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->signals.rows(), 100U);
  EXPECT_TRUE(opened->signals.has("actual_force_N"));
  EXPECT_FALSE(opened->signals.has("thumb_fx_counts"));
  EXPECT_NE(opened->damage.find("2 of its 3 channels"), std::string::npos) << opened->damage;
}

TEST_F(PatientCourseTest, EventsStandOnTheTimeAxisOfTheirTrial) {
  const storage::RowId session = add_session(*store_, "P-1", {});
  const auto trials = store_->trials(session);
  for (const auto& event : {storage::EventRecord{(*trials)[1].id, 1.5, "fault", "no samples"},
                            storage::EventRecord{std::nullopt, 2.5, "note", "moved"},
                            storage::EventRecord{std::nullopt, 500.0, "note", "much later"},
                            storage::EventRecord{(*trials)[2].id, 1.0, "pause", ""}})
    ASSERT_TRUE(store_->add_event(session, event).ok());
  const auto all = course();
  const auto opened = open_trial(*store_, all.sessions[0].record, (*trials)[1]);
  ASSERT_EQ(opened->marks.size(), 2U);
  EXPECT_EQ(opened->marks[0].kind, "fault");
  EXPECT_EQ(opened->marks[0].t_s, 1.5);
  EXPECT_EQ(opened->marks[1].text, "moved");
}

TEST_F(PatientCourseTest, FactsSayWhatMakesATrialDoubtful) {
  OpenedTrial opened;
  opened.trial.status = storage::TrialStatus::interrupted;
  opened.trial.helped = true;
  opened.trial.seed = 18446744073709551615ULL;
  opened.trial.preparations = {1};
  opened.trial.drift = {{"drift_N", 0.7}};
  opened.trial.drifted = true;
  opened.trial.health_json = R"({"index": {"lost": 3, "torn": 0}, "kernel_drops": 0})";
  std::map<QString, TrialFact> facts;
  for (auto& fact : facts_of(opened)) facts[fact.what] = fact;
  EXPECT_TRUE(facts.at("Ended").doubtful);
  EXPECT_TRUE(facts.at("Zero drift").doubtful);
  EXPECT_TRUE(facts.at("Counts as").value.contains("helped"));
  EXPECT_EQ(facts.at("Seed").value, "18446744073709551615");
  EXPECT_EQ(facts.at("Sensors and bus").value, "Index: lost 3");
}

}  // namespace
}  // namespace isograsp::gui::patient_course_test
