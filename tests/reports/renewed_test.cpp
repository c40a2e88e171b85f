// SPDX-License-Identifier: GPL-3.0-or-later
// A corrected measure ends no course: trials that were scored by an older version are scored again
// from their signals, in reports and in verdicts; what is stored stays as it is.
#include "reports/findings/renewed.hpp"

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "reports/findings/patient_records.hpp"
#include "reports/findings/patient_verdicts.hpp"
#include "reports/findings/progress_report.hpp"
#include "reports/findings/report_text.hpp"
#include "storage/access/open_store.hpp"
#include "tasks/measure_version.hpp"
#include "tests/reports/demo_clinic.hpp"
#include "tests/reports/emitted_measures.hpp"
#include "tests/support/every.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::reports::renewed_test {
namespace {

using test::must;

TEST(MeasureVersion, OfEveryMeasureThatATaskGivesIsThatOfTheProgramAndOlderOnesAreTold) {
  std::size_t seen = 0;
  for (const auto& task : test::every(test::emitted()))
    for (Measure measure : test::every(task.measures)) {
      ++seen;
      EXPECT_FALSE(tasks::is_older(measure)) << measure.name << " of " << measure.channel;
      --measure.version;
      EXPECT_TRUE(tasks::is_older(measure)) << measure.name << " of " << measure.channel;
    }
  EXPECT_GT(seen, 0U);
  Measure foreign;
  foreign.name = "of another program";
  foreign.version = 1;
  EXPECT_FALSE(tasks::is_older(foreign));
}

/// The lines of all series, for comparing reports.
std::string series_of(const ReportContent& content) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& section : content.sections) {
    for (const auto& series : section.series) {
      text << section.task << ' ' << series.name << ' ' << series.channel << ' ' << series.version;
      for (const auto& value : series.values)
        for (const double trial : value.trials) text << ' ' << trial;
      text << ' ' << english(series.trend) << '\n';
    }
    for (const auto& note : section.notes) text << english(note) << '\n';
  }
  return text.str();
}

class Renewed : public testing::Test {
 protected:
  void SetUp() override { open(); }
  void open() {
    store_.reset();
    store_ = must(storage::open_store(path_, storage::OpenMode::scratch));
  }
  /// As if an older program had scored: another version, another value.
  void make_older(const std::string& where) {
    execute(
        "UPDATE measures SET version = version - 1, value = value * 1.5, sample_count = 7 "
        "WHERE " +
        where);
  }
  void execute(const std::string& statement) {
    store_.reset();
    {
      soci::session sql(soci::sqlite3, "db=\"" + path_ + "\"");
      std::istringstream all(statement);
      for (std::string one; std::getline(all, one, ';');) sql << one;
    }
    open();
  }
  std::vector<Measure> stored(const std::string& code) {
    std::vector<Measure> all;
    const auto patient = must(store_->find_patient(code));
    for (const auto& session : must(store_->sessions(patient->id)))
      for (const auto& trial : must(store_->trials(session.id)))
        for (auto& measure : must(store_->measures_of_all_versions(trial.id)))
          all.push_back(measure);
    return all;
  }
  ReportContent report(const std::string& code = "TK-1") {
    return must(gather_progress(*store_, code));
  }
  /// What was stored is there to the bit, and `newer` results beside it.
  void expect_kept(const std::vector<Measure>& as_stored, std::size_t newer) {
    const auto all = stored("TK-1");
    EXPECT_EQ(all.size(), as_stored.size() + newer);
    for (const Measure& one : test::every(as_stored))
      EXPECT_NE(std::find(all.begin(), all.end(), one), all.end())
          << one.name << " of " << one.channel;
  }
  PatientRecords records(const std::string& code = "TK-1") {
    return must(read_patient(*store_, code));
  }
  /// As if the program began anew, and what it would have to read were gone: results come from the
  /// database, or not at all.
  void lose_signals() {
    execute(
        "UPDATE trials SET signals_blake2b = randomblob(32); "
        "UPDATE signal_packs SET values_blake2b = zeroblob(32)");
  }
  static const QualityLine* line(const ReportContent& content, const std::string& label) {
    for (const auto& one : content.quality)
      if (english(one.label) == label) return &one;
    return nullptr;
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.path("clinic.db");
  std::unique_ptr<storage::SessionStore> store_;
};

TEST_F(Renewed, ACourseThatAnOlderProgramBeganIsOneCourse) {
  test::add_course(*store_, "TK-1", false);
  const auto before = report();
  EXPECT_EQ(line(before, "Newer measures"), nullptr) << "nothing is older";
  make_older("value IS NOT NULL AND trial_id <= (SELECT max(id) - 8 FROM trials)");
  const auto as_stored = stored("TK-1");
  const auto after = report();
  EXPECT_EQ(series_of(after), series_of(before));
  ASSERT_NE(line(after, "Newer measures"), nullptr);
  EXPECT_NE(
      english(line(after, "Newer measures")->text).find("computed again from the stored signals"),
      std::string::npos);
  EXPECT_FALSE(line(after, "Newer measures")->attention);
  const auto older = std::count_if(as_stored.begin(), as_stored.end(),
                                   [](const Measure& measure) { return measure.samples == 7; });
  expect_kept(as_stored, static_cast<std::size_t>(older));
  EXPECT_EQ(
      english(line(after, "Newer measures")->text).find(std::to_string(older) + " results of "), 0u)
      << english(line(after, "Newer measures")->text);
}

TEST_F(Renewed, OnlyWhatIsOlderIsComputedAgain) {
  test::add_course(*store_, "TK-1", false);
  // A stored value of the present version is believed, whatever its signals would give.
  execute("UPDATE measures SET value = 77.0 WHERE name = 'maximum_force'");
  make_older("name = 'relative_rmse' AND value IS NOT NULL");
  const auto points = must(renewed_progress(*store_, must(store_->find_patient("TK-1"))->id));
  int maxima = 0, errors = 0;
  for (const auto& point : test::every(points)) {
    if (point.measure.name == "maximum_force") {
      EXPECT_EQ(point.measure.value, 77.0);
      ++maxima;
    }
    if (point.measure.name == "relative_rmse" && point.measure.value) {
      EXPECT_NE(point.measure.samples, 7);
      ++errors;
    }
  }
  EXPECT_GT(maxima, 0);
  EXPECT_GT(errors, 0);
}

TEST_F(Renewed, TheNextReportScoresNothingAgain) {
  test::DemoSession demo;
  constexpr int kSessions = 3;
  const char* const dates[kSessions] = {"2026-03-02", "2026-03-05", "2026-03-09"};
  for (int i = 0; i < kSessions; ++i) {
    demo.date = dates[i];
    demo.skill = 0.531 + 0.01 * i;  // signals that no other test has scored
    test::add_session(*store_, "TK-1", demo);
  }
  const auto before = series_of(report());
  make_older("value IS NOT NULL");
  const auto first = records();
  EXPECT_GT(first.scored_again, 0);
  EXPECT_EQ(first.scored_again, first.renewed_trials);
  lose_signals();
  const auto second = records();
  EXPECT_EQ(second.scored_again, 0);
  EXPECT_EQ(second.renewed_results, first.renewed_results) << "the report says it all the same";
  EXPECT_EQ(second.not_renewed_trials, 0);
  EXPECT_EQ(series_of(report()), before);
}

TEST_F(Renewed, OfAFileThatIsOnlyReadNothingIsChangedAndTheReportIsTheSame) {
  test::add_course(*store_, "TK-1", false);
  const auto before = series_of(report());
  make_older("value IS NOT NULL");
  const auto as_stored = stored("TK-1");
  store_.reset();
  store_ = must(storage::open_store(path_, storage::OpenMode::read_only));
  EXPECT_EQ(series_of(report()), before);
  expect_kept(as_stored, 0);
  EXPECT_EQ(records().not_renewed_trials, 0);
}

TEST_F(Renewed, WhileSomebodyRecordsIntoTheFileNothingIsKeptAfterwardsItIs) {
  test::add_course(*store_, "TK-1", false);
  const auto before = series_of(report());
  make_older("value IS NOT NULL");
  const auto as_stored = stored("TK-1");
  {
    const auto recorder = must(storage::open_store(path_, storage::OpenMode::scratch));
    storage::SessionRecord session;
    session.patient_id = must(recorder->add_patient("TK-2")).id;
    session.started_utc = "2026-05-01T09:00:00Z";
    session.device_uri = "can://can0";
    storage::TrialRecord trial;
    trial.session_id = must(recorder->begin_session(session));
    trial.number = 1;
    trial.task_name = "Maximum";
    trial.groups = {{"task", {"t_s"}}};
    trial.id = must(recorder->begin_trial(trial));
    EXPECT_EQ(series_of(report()), before);
    expect_kept(as_stored, 0);
    trial.status = storage::TrialStatus::aborted;
    must(recorder->end_trial(trial, {}));
  }
  EXPECT_EQ(series_of(report()), before);
  EXPECT_GT(stored("TK-1").size(), as_stored.size());
}

TEST_F(Renewed, ATrialWhoseSignalsAreLostKeepsItsOlderResultAndIsNotCompared) {
  test::DemoSession demo;
  const char* const dates[] = {"2026-03-02", "2026-03-05", "2026-03-09"};
  for (int i = 0; i < 3; ++i) {
    demo.date = dates[i];
    demo.skill = 0.511 + 0.01 * i;  // signals that no other test has scored
    test::add_session(*store_, "TK-1", demo);
  }
  make_older("name = 'maximum_force' AND trial_id = 2");
  execute("UPDATE signal_packs SET values_blake2b = zeroblob(32) WHERE trial_id = 2");
  const auto content = report();
  ASSERT_NE(line(content, "Older measures"), nullptr);
  EXPECT_TRUE(line(content, "Older measures")->attention);
  EXPECT_EQ(english(line(content, "Older measures")->text).find("1 trial "), 0u);
  EXPECT_NE(series_of(content).find("another version of the measure"), std::string::npos);
}

TEST_F(Renewed, VerdictsAndTheirPoolsUseThemToo) {
  for (int person = 0; person < 10; ++person) {
    const std::string code = "S-" + std::to_string(person + 1);
    for (const int day : {3, 6}) {
      test::DemoSession demo;
      demo.date = "2026-02-0" + std::to_string(day);
      demo.skill = 0.05 * person + (day == 3 ? 0.0 : 0.02 * (person % 3 - 1));
      test::add_session(*store_, code, demo);
    }
    const storage::RowId id = must(store_->find_patient(code))->id;
    must(store_->set_profile(id, {storage::Side::right, {}, "", "", ""}));
    must(store_->add_stable_period(id, {0, "2026-02-01", "2026-02-28", "", "Dr 3", ""}));
  }
  test::add_course(*store_, "TK-1", false);
  const storage::RowId patient = must(store_->find_patient("TK-1"))->id;
  must(store_->set_profile(patient, {storage::Side::right, {}, "", "", ""}));
  auto choice = must(primary_choices(*store_, "TK-1")).at(0);
  choice.chosen_by = "Therapist 7";
  choice.chosen_utc = "2026-03-01T08:00:00Z";
  must(store_->add_primary_measure(patient, choice));
  const auto before = must(gather_verdicts(*store_, "TK-1")).at(0).verdict.value();
  ASSERT_EQ(before.people, 10) << english(before.reason);
  ASSERT_TRUE(before.change.mdc_up);
  make_older("name = '" + choice.measure +
             "' AND trial_id NOT IN (SELECT id FROM trials ORDER BY id DESC LIMIT 8)");
  const auto after = must(gather_verdicts(*store_, "TK-1")).at(0).verdict.value();
  EXPECT_EQ(after.people, 10) << english(after.reason);
  EXPECT_EQ(after.change.verdict, before.change.verdict);
  EXPECT_EQ(after.change.baseline, before.change.baseline);
  EXPECT_EQ(after.change.mdc_up, before.change.mdc_up);
}

}  // namespace
}  // namespace isograsp::reports::renewed_test
