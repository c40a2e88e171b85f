// SPDX-License-Identifier: GPL-3.0-or-later
// Verdicts in the report: whose days make the pool, what breaks a series, what stands on the page.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "kinematics/pose_task.hpp"
#include "reports/findings/comparable.hpp"
#include "reports/findings/patient_verdicts.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "reports/findings/verdicts.hpp"
#include "reports/paper/html_writer.hpp"
#include "reports/paper/pdf_writer.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/facts/measure_words.hpp"
#include "tests/reports/paper_test.hpp"
#include "tests/support/every.hpp"
#include "tests/support/made_up.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"
#include "tests/tasks/specs.hpp"

namespace isograsp::reports::verdict_report_test {
namespace {

using test::library_task_text;
using test::must;

/// One session of maxima.
struct Assessed {
  std::string date;
  std::vector<double> grip_N;
  Hand hand = Hand::left;
  bool simulated = false;
  int task_version = 1;
  std::string task_suffix = {};
  std::optional<double> gain = 0.5;
  double maximum_force_N = 10.0;
  std::string task_file = "maximum_grip.toml";
  std::string time = "09:30:00";
  std::string measure = "maximum_force";
  int without_value = 0;  ///< trials more
  std::string rig = {};   ///< of an arm seen by markers
  std::string postures = "0a";
  std::string uri = "can://can0";
};

/// References of an arm, adapted to one start posture.
std::string references_of(const std::string& postures, storage::RowId session) {
  PoseTask task;
  task.frame = "object";
  task.postures_hash = postures;
  task.references = {
      {"turned", {Vec3(0.01 * static_cast<double>(session), 0.0, 0.0), Quat::Identity()}}};
  task.targets = {0};
  task.position_tolerance_m = task.angle_tolerance_rad = 0.1;
  task.time_limit_s = 10.0;
  return pose_task_text(task);
}

class VerdictReport : public testing::Test {
 protected:
  void SetUp() override {
    test::draw_without_a_display();
    store_ = must(storage::open_store(folder_.path("clinic.db"), storage::OpenMode::scratch));
  }

  storage::RowId person(const std::string& code,
                        std::optional<storage::Side> affected = storage::Side::left,
                        const std::string& onset = "") {
    const storage::RowId id = must(store_->add_patient(code)).id;
    must(store_->set_profile(id, {affected, {}, onset, "", ""}));
    return id;
  }
  void tell(storage::RowId person, storage::Side affected, storage::Sex sex, int birth_year) {
    must(store_->set_profile(person, {affected, Hand::left, "", "", "", sex, birth_year}));
  }

  void assess(storage::RowId patient, const Assessed& what) {
    storage::SessionRecord session;
    session.patient_id = patient;
    session.started_utc = what.date + "T" + what.time + "Z";
    session.hand = what.hand;
    session.device_uri = what.uri;
    session.calibration = what.rig;
    session.simulated = what.simulated;
    session.rate_Hz = 100.0;
    const storage::RowId id = must(store_->begin_session(session));
    int number = 0;
    std::vector<std::optional<double>> values(what.grip_N.begin(), what.grip_N.end());
    values.resize(values.size() + static_cast<std::size_t>(what.without_value));
    for (const auto& value : values) {
      storage::TrialRecord trial;
      trial.session_id = id;
      trial.number = ++number;
      trial.task_name = "Maximum grip";
      trial.task_version = what.task_version;
      trial.task_text = library_task_text(what.task_file) + what.task_suffix;
      if (!what.rig.empty())  // references of an arm are those of its start posture: never the same
        trial.scene_text = references_of(what.postures, id);
      trial.references["maximum_force_N"] = what.maximum_force_N;
      trial.groups = {{"task", {"t_s", "actual_force_N"}}};
      trial.id = must(store_->begin_trial(trial));
      const std::vector<std::vector<double>> rows{{0.0, value.value_or(0.0), 0.01, 0.0}};
      must(store_->append_blocks(trial.id, 0, rows));
      trial.status = storage::TrialStatus::completed;
      storage::set_value(trial.references, "visual_gain_deg_per_N", what.gain);
      Measure measure;
      measure.name = what.measure;
      measure.channel = "grip";
      measure.unit = "N";
      measure.value = value;
      measure.version = test::kMadeUpVersion;
      Measure opposition = measure;
      opposition.name = "peak_force";
      must(store_->end_trial(trial, std::vector{measure, opposition}));
    }
    must(store_->end_session(id));
  }

  /// People who are judged stable in February, with a pair of days that differ by about `cv` each.
  void add_stable(int people, const Assessed& like = {"", {}},
                  storage::Side affected = storage::Side::left) {
    for (int i = 0; i < people; ++i) {
      const storage::RowId id = person("S-" + std::to_string(++stable_), affected);
      must(store_->add_stable_period(id, {0, "2026-02-01", "2026-02-28", "", "Dr 3", ""}));
      const double level = 5.0 * std::pow(1.2, i);
      const double step = 1.0 + (i % 2 == 0 ? 0.1 : -0.1) * std::sqrt(2.0);
      Assessed day = like;
      day.date = "2026-02-03";
      day.grip_N = {level};
      assess(id, day);
      day.date = "2026-02-06";
      day.grip_N = {level * step};
      assess(id, day);
    }
  }

  void choose(storage::RowId patient, const std::string& utc = "2026-03-01T08:00:00Z",
              const std::string& measure = "maximum_force") {
    must(store_->add_primary_measure(
        patient, {0, "Maximum grip", Hand::left, measure, "grip", utc, "Therapist 7"}));
  }

  /// A patient with these assessments in March, three days apart, and the measure chosen before.
  storage::RowId patient_with(const std::vector<double>& days,
                              std::optional<storage::Side> affected = storage::Side::left) {
    const storage::RowId id = person("TK-1", affected);
    choose(id);
    for (std::size_t i = 0; i < days.size(); ++i) {
      const std::size_t day = 2 + 3 * i;
      assess(id, {"2026-03-" + std::string(day < 10 ? "0" : "") + std::to_string(day), {days[i]}});
    }
    return id;
  }

  ReportContent gather() { return must(gather_progress(*store_, "TK-1")); }
  ChangeVerdict verdict() {
    const auto all = must(gather_verdicts(*store_, "TK-1"));
    const auto content = gather();
    for (const auto& section : test::every(content.sections))
      for (const auto& series : test::every(section.series))
        if (series.verdict) {
          EXPECT_EQ(verdict_words(*series.verdict), verdict_words(*all.at(0).verdict));
          EXPECT_EQ(verdict_basis(*series.verdict), verdict_basis(*all.at(0).verdict));
        }
    return all.at(0).verdict.value();
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<storage::SessionStore> store_;
  int stable_ = 0;
};

TEST_F(VerdictReport, BeyondTheErrorOfStablePeopleIsPossibleThenConfirmed) {
  add_stable(10);
  const storage::RowId id = patient_with({10, 10, 10.5});
  EXPECT_EQ(english(verdict_words(verdict())), "not larger than measurement error");
  EXPECT_EQ(english(verdict_basis(verdict())), "10 stable people");
  assess(id, {"2026-03-20", {19, 20, 21}});
  EXPECT_EQ(english(verdict_words(verdict())), "improved (possible)");
  EXPECT_EQ(english(verdict_basis(verdict())), "one assessment so far, 10 stable people");
  assess(id, {"2026-03-23", {19}});
  EXPECT_EQ(english(verdict_words(verdict())), "improved (confirmed)");
  EXPECT_EQ(english(verdict_basis(verdict())), "two assessments in a row, 10 stable people");
  assess(id, {"2026-03-26", {4}});
  EXPECT_EQ(english(verdict_words(verdict())), "worsened (possible)");
}

TEST_F(VerdictReport, TheErrorIsThatOfTheFormula) {
  add_stable(10);
  patient_with({10, 10, 10.5});
  // Logarithms: every pair differs by log(1 +- 0.1 sqrt 2); one trial a day.
  const double up = std::log(1.0 + 0.1 * std::sqrt(2.0));
  const double down = std::log(1.0 - 0.1 * std::sqrt(2.0));
  const double few = 1.0 - 0.2 * std::pow(10.0, -0.75);  // pairs
  const double s_day = std::sqrt((up * up + down * down) / 4.0 / (0.94449647 * few));
  constexpr double kT975 = 2.728961;  // 4.1839 degrees of freedom
  const double mdc = kT975 * s_day * std::sqrt(1.5);
  EXPECT_WITHIN(*verdict().change.mdc_up, 10.0 * std::expm1(mdc), 1e-4);
  EXPECT_WITHIN(*verdict().change.mdc_down, 10.0 * std::expm1(-mdc), 1e-4);
}

TEST_F(VerdictReport, NinePeopleAreTooFew) {
  add_stable(9);
  patient_with({10, 10, 20, 20});
  EXPECT_EQ(english(verdict_words(verdict())), "cannot be judged yet");
  EXPECT_EQ(english(verdict_basis(verdict())), "9 of 10 stable people");
}

TEST_F(VerdictReport, OtherHandsSourcesVersionsAndParametersDoNotCount) {
  patient_with({10, 10, 20, 20});
  add_stable(10, {"", {}}, storage::Side::right);
  EXPECT_EQ(verdict().people, 0) << "their other hand";
  add_stable(10, {"", {}}, storage::Side::none);
  EXPECT_EQ(verdict().people, 0) << "healthy people";
  add_stable(10, {"", {}, Hand::left, true});
  EXPECT_EQ(verdict().people, 0) << "simulated people";
  add_stable(10, {"", {}, Hand::left, false, 2});
  EXPECT_EQ(verdict().people, 0) << "another version of the task";
  add_stable(10, {"", {}, Hand::left, false, 1, "# changed\n"});
  EXPECT_EQ(verdict().people, 0) << "other parameters";
  add_stable(4, {"", {}, Hand::right}, storage::Side::right);
  EXPECT_EQ(verdict().people, 4) << "the affected hand, whichever it is";
}

/// An arm before cameras of Qualisys, the rig and postures that are named.
Assessed arm_day(const std::string& date, double value) {
  Assessed day{date, {value}};
  day.rig = "format = \"isograsp-rig-1\"\nname = \"a\"\n";
  day.uri = "qtm://10.0.0.7?rig=a";
  return day;
}

TEST_F(VerdictReport, AnArmIsComparedThoughItsReferencesAreThoseOfEachStartPosture) {
  const storage::RowId patient = person("P-7");
  choose(patient);
  for (const auto& [date, value] :
       {std::pair{"2026-03-02", 10.0}, {"2026-03-09", 10.0}, {"2026-03-16", 30.0}})
    assess(patient, arm_day(date, value));
  add_stable(12, arm_day("", 0.0));
  const auto content = must(gather_progress(*store_, "P-7"));
  ASSERT_EQ(content.sections.size(), 1u);
  EXPECT_TRUE(content.sections[0].breaks.empty());
  const auto& verdict = content.sections[0].series[0].verdict;
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->people, 12);
  EXPECT_EQ(english(verdict->reason), "");
}

TEST_F(VerdictReport, AnotherRigPosturesCamerasOrToleranceBeginANewSeriesOfAnArm) {
  Assessed rig = arm_day("2026-03-09", 10.0);
  rig.rig += "max_residual_m = 0.02\n";
  Assessed postures = arm_day("2026-03-09", 10.0);
  postures.postures = "0b";
  Assessed cameras = arm_day("2026-03-09", 10.0);
  cameras.uri = "natnet://10.0.0.7?rig=a";
  Assessed tolerance = arm_day("2026-03-09", 10.0);
  tolerance.task_suffix = "\n# position_tolerance_m = 0.03\n";
  int number = 0;
  for (const auto& [other, why] : {std::pair{rig, "other rig of markers"},
                                   {postures, "other postures"},
                                   {cameras, "other system of cameras"},
                                   {tolerance, "other task parameters"}}) {
    const std::string code = "Q-" + std::to_string(++number);
    const storage::RowId patient = person(code);
    assess(patient, arm_day("2026-03-02", 10.0));
    assess(patient, other);
    const auto content = must(gather_progress(*store_, code));
    ASSERT_EQ(content.sections.size(), 1u) << why;
    ASSERT_EQ(content.sections[0].breaks.size(), 1u) << why;
    EXPECT_EQ(english(content.sections[0].breaks[0].reason), why);
    EXPECT_EQ(english(content.sections[0].notes.at(0)),
              std::string("Session 1 not compared: ") + why);
    EXPECT_EQ(content.sections[0].series.at(0).values.size(), 1u) << why;
    // Nor do stable people who were measured in the former way stand in its pool.
    choose(patient);
    add_stable(3, arm_day("", 0.0));
    EXPECT_EQ(must(gather_progress(*store_, code)).sections[0].series[0].verdict->people, 0) << why;
  }
}

TEST_F(VerdictReport, NobodyIsJudgedByTheirOwnVariation) {
  add_stable(9);
  const storage::RowId id = patient_with({10, 11, 20, 20});
  must(store_->add_stable_period(id, {0, "2026-03-01", "2026-03-06", "", "Dr 3", ""}));
  EXPECT_EQ(verdict().people, 9);
  add_stable(1);
  EXPECT_EQ(verdict().people, 10);
}

TEST_F(VerdictReport, HealthyPeopleMakeABandFromTwentyOfTheSameKindOn) {
  const storage::RowId id = patient_with({10, 10});
  const auto norm = [&] { return gather().sections.at(0).series.at(0).norm; };
  tell(id, storage::Side::left, storage::Sex::female, 1961);  // 65 in 2026
  EXPECT_FALSE(norm());
  auto healthy = [&, number = 0](storage::Sex sex, int birth_year, Assessed how) mutable {
    const storage::RowId one = must(store_->add_patient("H-" + std::to_string(++number))).id;
    tell(one, storage::Side::none, sex, birth_year);
    assess(one, how);
  };
  healthy(storage::Sex::male, 1961, {"2026-02-03", {99}});
  healthy(storage::Sex::female, 1967, {"2026-02-03", {99}});                    // 59
  healthy(storage::Sex::female, 1961, {"2026-02-03", {99}, Hand::right});       // not dominant
  healthy(storage::Sex::female, 1961, {"2026-02-03", {99}, Hand::left, true});  // simulated
  EXPECT_FALSE(norm());
  for (int i = 1; i < 20; ++i)
    healthy(storage::Sex::female, 1957 + i % 10, {"2026-02-03", {double(i), i + 2.0}});
  ASSERT_TRUE(norm());
  EXPECT_EQ(norm()->values.size(), 19u);
  EXPECT_FALSE(norm()->low) << "nineteen are too few";
  EXPECT_NE(glance_rows(gather()).at(0).beside.find("n\u00a019, no band"), std::string::npos);
  healthy(storage::Sex::female, 1961, {"2026-02-03", {20, 22}});
  ASSERT_TRUE(norm()->low);
  EXPECT_EQ(english(norm()->people), "women of 60 to 69, dominant hand");
  // Means 2, 3 ... 21; positions 0.05 and 0.95 of the way from the first to the last.
  EXPECT_WITHIN(*norm()->low, 2.0 + 0.05 * 19.0, 1e-12);
  EXPECT_WITHIN(*norm()->high, 21.0 - 0.05 * 19.0, 1e-12);
  EXPECT_EQ(glance_rows(gather()).at(0).beside,
            "healthy 2.95 to 20.1\u00a0N (n\u00a0"
            "20)");
  tell(id, storage::Side::left, storage::Sex::female, 1966);  // 60
  EXPECT_TRUE(norm());
  tell(id, storage::Side::left, storage::Sex::other, 1961);
  EXPECT_FALSE(norm());
  tell(id, storage::Side::left, storage::Sex::female, 1961);
  Assessed training{"2026-03-20", {10}};
  training.task_file = "grip_sine_training.toml";
  healthy(storage::Sex::female, 1961, training);
  assess(id, training);
  EXPECT_FALSE(norm()) << "levels that follow success are no assessment";
}

TEST_F(VerdictReport, TheOtherHandStandsBesideTheLastValue) {
  const storage::RowId id = patient_with({10, 10, 12});
  EXPECT_EQ(glance_rows(gather()).at(0).beside, "");
  assess(id, {"2026-03-11", {31}, Hand::right});
  const auto rows = glance_rows(gather());
  ASSERT_EQ(rows.at(0).hand, "left hand");
  EXPECT_EQ(rows.at(0).beside, "right hand 31\u00a0N");
}

TEST_F(VerdictReport, AChangedDelayOfTheDisplayBeginsANewSeries) {
  add_stable(10);
  const storage::RowId id = patient_with({10, 10, 20, 20});
  EXPECT_EQ(english(verdict_words(verdict())), "improved (confirmed)");
  const auto sessions = must(store_->sessions(id));
  must(store_->add_answers(sessions.back().id, std::vector<storage::SessionAnswer>{
                                                   {"screen", "display_delay_s", "0.05"}}));
  EXPECT_EQ(english(verdict_basis(verdict())), "the baseline needs two assessment days");
  EXPECT_EQ(english(gather().sections.at(0).breaks.at(0).reason), "other delay of the display");
}

TEST_F(VerdictReport, TwoSessionsEitherSideOfMidnightUtcAreOneDay) {
  add_stable(10);
  const storage::RowId id = person("TK-1");
  choose(id);
  Assessed evening{"2026-03-02", {10}};
  evening.time = "21:00:00";
  Assessed night{"2026-03-03", {10}};
  night.time = "02:00:00";
  assess(id, evening);
  assess(id, night);
  EXPECT_EQ(english(verdict_basis(verdict())), "the baseline needs two assessment days");
  evening.date = night.date;  // 19 hours later, of the same date
  assess(id, evening);
  EXPECT_EQ(english(verdict_basis(verdict())), "no assessment after the baseline");
}

TEST_F(VerdictReport, AFailedDayNeitherBlocksTheBaselineNorDiffersBetweenTableAndVerdict) {
  add_stable(10);
  const storage::RowId id = person("TK-1");
  must(store_->add_primary_measure(id, {0, "Maximum grip", Hand::left, "release_time", "grip",
                                        "2026-03-01T08:00:00Z", "Therapist 7"}));
  const auto on = [&](const std::string& date, std::vector<double> release_s, int without = 0) {
    Assessed one{date, std::move(release_s)};
    one.measure = "release_time";
    one.without_value = without;
    assess(id, one);
  };
  on("2026-03-02", {2.0}, 1);
  on("2026-03-05", {3.0});
  on("2026-03-08", {5.0});
  on("2026-03-11", {4.5});
  const auto content = gather();
  const auto& series = content.sections.at(0).series.at(0);
  EXPECT_EQ(series.baseline, 4.0);
  EXPECT_EQ(english(series.baseline_basis), "first two days with a value");
  EXPECT_EQ(series.verdict.value().change.baseline, 4.0);
  EXPECT_EQ(english(series.verdict->reason), "0 of 10 stable people");
  on("2026-03-14", {}, 2);
  const auto later = gather();
  const auto& after = later.sections.at(0).series.at(0);
  EXPECT_EQ(after.baseline, 4.0) << "two days, though the last one failed";
  EXPECT_EQ(after.last, std::nullopt);
  EXPECT_EQ(english(after.verdict.value().reason), "the last assessment has no value");
}

TEST_F(VerdictReport, ADayOnWhichNothingCouldBeComputedIsNoAssessment) {
  add_stable(10);
  const storage::RowId id = person("TK-1");
  choose(id);
  Assessed empty{"2026-03-02", {}};
  empty.without_value = 2;
  assess(id, empty);
  for (const char* date : {"2026-03-05", "2026-03-08", "2026-03-11"}) assess(id, {date, {10}});
  EXPECT_EQ(english(verdict_words(verdict())), "not larger than measurement error");
  empty.date = "2026-03-14";
  assess(id, empty);
  EXPECT_EQ(english(verdict_basis(verdict())), "the last assessment has no value");
  assess(id, {"2026-03-17", {10}});
  EXPECT_EQ(english(verdict_words(verdict())), "not larger than measurement error");
}

TEST_F(VerdictReport, APartOfTheSessionsSaysNothingOfTheOthers) {
  const storage::RowId id = patient_with({10, 10, 10});
  must(store_->add_primary_measure(id, {0, "Let go", Hand::left, "release_time", "grip",
                                        "2026-03-01T08:00:00Z", "Therapist 7"}));
  const auto none = must(gather_progress(*store_, "TK-1", {}, {5, 7}));
  ASSERT_FALSE(none.quality.empty());
  EXPECT_EQ(english(none.quality[0].text), "none of the 3 sessions lies in it");
  const auto part = must(gather_progress(*store_, "TK-1", {}, {2, 3}));
  EXPECT_NE(english(part.waiting.at(0)).find("no assessment in these sessions"), std::string::npos);
  EXPECT_NE(english(gather().waiting.at(0)).find("no assessment yet"), std::string::npos);
  assess(id, {"2026-03-20", {10}, Hand::left, false, 2});
  const auto later = must(gather_progress(*store_, "TK-1", {}, {2, 4}));
  EXPECT_EQ(english(later.sections.at(0).notes.at(0)).find("Sessions 2, 3 "), 0u)
      << english(later.sections.at(0).notes.at(0));
}

TEST_F(VerdictReport, ABreakInASeriesOfStableDaysMakesNoPair) {
  patient_with({10, 10, 20});
  const storage::RowId id = person("S-1");
  must(store_->add_stable_period(id, {0, "2026-02-01", "2026-02-04", "", "Dr 3", ""}));
  must(store_->add_stable_period(id, {0, "2026-02-05", "2026-02-28", "", "Dr 3", ""}));
  assess(id, {"2026-02-03", {10}});
  assess(id, {"2026-02-06", {11}});
  EXPECT_EQ(verdict().people, 0) << "two times, not one";
  assess(id, {"2026-02-08", {11}, Hand::left, false, 1, "", 1.0, 20.0});
  EXPECT_EQ(verdict().people, 0) << "another gain";
  assess(id, {"2026-02-10", {11}, Hand::left, false, 1, "", 2.0, 10.0});
  EXPECT_EQ(verdict().people, 1) << "the same gain for a share of the maximum";
}

TEST_F(VerdictReport, AMeasureChosenAfterTheSecondAssessmentIsNotJudged) {
  add_stable(10);
  const storage::RowId id = person("TK-1");
  choose(id, "2026-03-08T09:29:00Z");
  for (const char* date : {"2026-03-02", "2026-03-05", "2026-03-08"}) assess(id, {date, {10}});
  EXPECT_EQ(english(verdict_words(verdict())), "not larger than measurement error")
      << "a minute before";
  must(store_->remove_primary_measure(must(store_->primary_measures(id)).at(0).id));
  choose(id, "2026-03-08T09:31:00Z");
  EXPECT_EQ(english(verdict_words(verdict())), "cannot be judged yet");
  EXPECT_EQ(english(verdict_basis(verdict())),
            "chosen on 8\u00a0Mar\u00a02026, after the second assessment");
  // A new series begins anew, with its own first and second assessment.
  assess(id, {"2026-03-11", {10}, Hand::left, false, 2});
  EXPECT_EQ(english(verdict_basis(verdict())), "the baseline needs two assessment days");
}

TEST_F(VerdictReport, LevelsThatFollowSuccessAndUnknownSidesAreNotJudged) {
  add_stable(10);
  const storage::RowId id = patient_with({10, 10, 20}, std::nullopt);
  EXPECT_EQ(english(verdict_basis(verdict())), "the affected side is not known");
  must(store_->set_profile(id, {storage::Side::both, {}, "", "", ""}));
  EXPECT_EQ(english(verdict_words(verdict())), "improved (possible)");
  Assessed training{"2026-03-20", {10}};
  training.task_file = "grip_sine_training.toml";
  training.task_suffix = "\n[chosen]\nlevel = 0.5\n";
  assess(id, training);
  EXPECT_EQ(english(verdict_basis(verdict())), "the level of its trials follows success");
}

TEST_F(VerdictReport, OnlyPrimaryMeasuresGetOneAndThePageSaysWhoChoseThem) {
  add_stable(10);
  const storage::RowId id = person("TK-1");
  for (const char* date : {"2026-03-02", "2026-03-05", "2026-03-08"}) assess(id, {date, {10}});
  auto rows = glance_rows(gather());
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].primary);
  EXPECT_EQ(rows[0].verdict, "\u2013");
  EXPECT_NE(english(verdict_notes(gather()).at(0)).find("No primary measure"), std::string::npos);
  choose(id);
  choose(id, "2026-03-01T08:00:00Z", "peak_force");  // is drawn in no trend otherwise
  must(store_->add_primary_measure(id, {0, "Let go", Hand::left, "release_time", "grip",
                                        "2026-03-01T08:00:00Z", "Therapist 7"}));
  const auto content = gather();
  rows = glance_rows(content);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].verdict, "not larger than measurement error");
  EXPECT_EQ(rows[0].mdc.find("MDC95"), 0u);
  EXPECT_EQ(rows[1].verdict, "cannot be judged yet");
  EXPECT_EQ(rows[1].verdict_basis, "more of it is neither better nor worse");
  std::string notes;
  for (const auto& note : verdict_notes(content)) notes += english(note) + "\n";
  EXPECT_NE(notes.find("by Therapist 7, 1\u00a0Mar\u00a02026"), std::string::npos) << notes;
  EXPECT_NE(notes.find("Release time (Let go, left hand), no assessment yet"), std::string::npos);
}

TEST_F(VerdictReport, EarlyAfterTheOnsetTheCauseOfAChangeIsLeftOpen) {
  const storage::RowId id = patient_with({10, 10, 10});  // the last one on 8 March
  const auto says_so = [&](const std::string& onset) {
    must(store_->set_profile(id, {storage::Side::left, {}, onset, "", ""}));
    const auto notes = verdict_notes(gather());
    return std::any_of(notes.begin(), notes.end(), [](const Text& note) {
      return english(note).find("change does not show what caused it") != std::string::npos;
    });
  };
  EXPECT_TRUE(says_so("2025-09-09"));
  EXPECT_FALSE(says_so("2025-09-08"));
  EXPECT_FALSE(says_so(""));
}

TEST_F(VerdictReport, PdfAndHtmlSayTheSame) {
  add_stable(12);
  const storage::RowId id = patient_with({10, 10, 10.5, 20});
  assess(id, {"2026-03-20", {19, 21}});
  must(store_->set_profile(id, {storage::Side::left, {}, "2025-12-01", "", ""}));
  const auto content = gather();
  const std::string pdf = folder_.path("verdict.pdf");
  const std::string html = folder_.path("verdict.html");
  must(write_pdf(content, pdf));
  must(write_html(content, html));
  if (const char* keep = std::getenv("ISOGRASP_KEEP_REPORTS"); keep != nullptr)
    for (const auto& file : {pdf, html})
      std::filesystem::copy_file(
          file, std::filesystem::path(keep) / std::filesystem::path(file).filename(),
          std::filesystem::copy_options::overwrite_existing);
  const auto plain = [](std::string text) {  // without spaces of any kind: lines are broken
    for (const std::string space : {"\u00a0", "\n", "\f", " "})
      for (auto at = text.find(space); at != std::string::npos; at = text.find(space))
        text.erase(at, space.size());
    for (const auto& [ligature, letters] :
         {std::pair<std::string, std::string>{"\ufb01", "fi"}, {"\ufb00", "ff"}})
      for (auto at = text.find(ligature); at != std::string::npos; at = text.find(ligature))
        text.replace(at, ligature.size(), letters);
    return text;
  };
  std::vector<std::string> said;
  for (const auto& row : glance_rows(content))
    for (const auto& text : {row.baseline, row.last, row.change, row.mdc, row.verdict})
      said.push_back(text);
  const std::string page = plain(test::read_file(html));
  for (const auto& text : test::every(said))
    EXPECT_NE(page.find(plain(text)), std::string::npos) << text;
  for (const auto& note : test::every(verdict_notes(content)))
    EXPECT_NE(page.find(plain(english(note))), std::string::npos) << english(note);
  const std::string command =
      "pdftotext -layout '" + pdf + "' '" + folder_.path("text.txt") + "' 2>&1";
  if (std::system(command.c_str()) != 0) GTEST_SKIP() << "pdftotext is not installed";
  const std::string paper = plain(test::read_file(folder_.path("text.txt")));
  for (const auto& text : test::every(said))
    EXPECT_NE(paper.find(plain(text)), std::string::npos) << text;
  EXPECT_NE(paper.find(plain("two assessments in a row")), std::string::npos);
  EXPECT_NE(paper.find(plain("change does not show what caused it")), std::string::npos);
}

TEST(SameGain, HoldsPerNewtonOrPerShareOfTheMaximum) {
  EXPECT_TRUE(same_gain({0.5, 10.0}, {0.5, 20.0}));
  EXPECT_TRUE(same_gain({0.5, 20.0}, {1.0, 10.0}));
  EXPECT_FALSE(same_gain({0.5, 20.0}, {1.0, 20.0}));
}

TEST(SameGain, OneThatIsNotKnownEqualsNoneThatIsKnown) {
  // Else 0.5 and 1.0 would stand in one series with it.
  EXPECT_FALSE(same_gain({0.5, 20.0}, {std::nullopt, 20.0}));
  EXPECT_FALSE(same_gain({std::nullopt, 20.0}, {0.5, 20.0}));
  EXPECT_TRUE(same_gain({std::nullopt, 20.0}, {std::nullopt, 10.0}));
}

TEST(DayCounter, ADayIsTheSessionsWithinTwelveHoursWhateverTheirDates) {
  DayCounter auckland;  // 10:00 and 15:00 there, then 10:00 on the next day
  EXPECT_EQ(auckland.day_of("2026-03-01T21:00:00Z"), 0.0);
  EXPECT_EQ(auckland.day_of("2026-03-02T02:00:00Z"), 0.0) << "another date in UTC, the same day";
  EXPECT_EQ(auckland.day_of("2026-03-02T21:00:00Z"), 1.0) << "the same date in UTC, another day";
  EXPECT_EQ(auckland.day_of("tomorrow"), 1.0);
  DayCounter europe;
  EXPECT_EQ(europe.day_of("2026-03-01T16:00:00Z"), 0.0);
  EXPECT_EQ(europe.day_of("2026-03-02T06:00:00Z"), 14.0 / 24.0) << "the next morning";
  EXPECT_EQ(europe.day_of("2026-03-02T18:00:00Z"), 26.0 / 24.0);
}

TEST_F(VerdictReport, SaysWhichPairsWereLeftOutAndWhereAFallCannotBeTold) {
  Assessed day{"", {}};
  day.measure = "pauses";  // its error does not grow with its mean
  for (int i = 0; i < 11; ++i) {
    const storage::RowId id = person("S-" + std::to_string(i + 1));
    must(store_->add_stable_period(id, {0, "2026-02-01", "2026-02-28", "", "Dr 3", ""}));
    day.date = "2026-02-03";
    day.grip_N = {3.0};
    assess(id, day);
    day.date = "2026-02-06";
    day.grip_N = {i == 5 ? 60.0 : 3.0 + (i % 2 == 0 ? 1.0 : -1.0) * (1.0 + 0.1 * i)};
    assess(id, day);
  }
  const storage::RowId id = person("TK-1");
  choose(id, "2026-03-01T08:00:00Z", "pauses");
  for (const auto& [date, pauses] :
       {std::pair{"2026-03-02", 2.0}, {"2026-03-05", 2.0}, {"2026-03-08", 2.5}}) {
    day.date = date;
    day.grip_N = {pauses};
    assess(id, day);
  }
  const auto one = verdict();
  EXPECT_EQ(one.change.verdict, Verdict::within_error);
  EXPECT_LT(*one.change.mdc_up, 5.0) << "one outlying day is not everybody's error";
  EXPECT_EQ(english(verdict_basis(one)),
            "11 stable people, 1 outlying pair left out; a fall cannot be told");
  const std::string html = folder_.path("fall.html");
  must(write_html(gather(), html));
  EXPECT_NE(test::read_file(html).find("a fall cannot be told"), std::string::npos);
}

TEST(MeasuresBelowZero, AreThoseWhoseScaleHasNoEndAtZero) {
  EXPECT_TRUE(tasks::words_of("individuation_index", "").below_zero);
  EXPECT_TRUE(tasks::words_of("grip_load_correlation", "").below_zero);
  EXPECT_FALSE(tasks::words_of("maximum_force", "grip").below_zero);
  EXPECT_FALSE(tasks::words_of("lag", "force").below_zero) << "judged by its distance";
}

}  // namespace
}  // namespace isograsp::reports::verdict_report_test
