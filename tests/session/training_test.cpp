// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/training.hpp"

#include <gtest/gtest.h>

#include "storage/access/open_store.hpp"
#include "tasks/kinds/force/force_tracking.hpp"
#include "tasks/measure_version.hpp"
#include "tasks/score.hpp"
#include "tasks/task.hpp"
#include "tests/support/every.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/within.hpp"

namespace isograsp::session::training_test {
namespace {

const std::string kTask =
    "format = \"isograsp-task-1\"\nname = \"train\"\ninstruction = \"do\"\nkind = "
    "\"force_tracking\"\nleast_fraction = 0.1\nmost_fraction = 0.3\n[difficulty]\nfactor = "
    "\"frequency\"\neasiest = 1\nhardest = 2\nstart = 0.4\nsuccess_measure = "
    "\"time_in_range\"\nsuccess_at_least = 60\n";

tasks::TaskSpec task() {
  return tasks::parse_task(kTask, "train.toml").value();
}

/// A clinic whose trials are made by hand.
struct Clinic {
  test::TemporaryFolder folder;
  std::unique_ptr<storage::SessionStore> store =
      storage::open_store(folder.path("c.db"), storage::OpenMode::create).value();
  storage::RowId patient = store->add_patient("P-1").value().id;

  storage::SessionRecord session(const std::string& utc, Hand hand, bool simulated) {
    storage::SessionRecord record;
    record.patient_id = patient;
    record.started_utc = utc;
    record.hand = hand;
    record.simulated = simulated;
    record.id = store->begin_session(record).value();
    return record;
  }
  void trial(const storage::SessionRecord& session, const std::string& text, const Measure& measure,
             storage::TrialStatus status = storage::TrialStatus::completed) {
    storage::TrialRecord record;
    record.session_id = session.id;
    record.number = ++number;
    record.task_name = "train";
    record.task_text = text;
    record.groups = {{"task", {"t_s"}}};
    record.id = store->begin_trial(record).value();
    record.status = status;
    ASSERT_TRUE(store->end_trial(record, std::vector{measure}).ok());
  }
  int number = 0;
};

Measure measured(const std::string& name, const std::string& channel, double value) {
  Measure measure;
  measure.name = name;
  measure.channel = channel;
  measure.value = value;
  measure.version = tasks::measure_version(name);
  return measure;
}
Measure on_target(double percent) {
  return measured("time_in_range", "force", percent);
}

TEST(Training, BeginsAtTheStartAndGoesOnWhereItStopped) {
  Clinic clinic;
  const auto now = clinic.session("2026-01-09T09:00:00Z", Hand::right, true);
  EXPECT_EQ(Training::read(*clinic.store, now).value().level(task()), 0.4);
  const auto before = clinic.session("2026-01-05T09:00:00Z", Hand::right, true);
  clinic.trial(before, tasks::at_level(task(), 0.4).value().text, on_target(70.0));
  clinic.trial(before, tasks::at_level(task(), 0.45).value().text, on_target(30.0));
  EXPECT_DOUBLE_EQ(Training::read(*clinic.store, now).value().level(task()), 0.30);
}

TEST(Training, OtherHandsDevicesAbortsAndPlainTrialsSayNothing) {
  Clinic clinic;
  const auto now = clinic.session("2026-01-09T09:00:00Z", Hand::right, false);
  const std::string text = tasks::at_level(task(), 0.9).value().text;
  clinic.trial(clinic.session("2026-01-05T09:00:00Z", Hand::left, false), text, on_target(99.0));
  clinic.trial(clinic.session("2026-01-05T09:00:00Z", Hand::right, true), text, on_target(99.0));
  const auto same = clinic.session("2026-01-05T09:00:00Z", Hand::right, false);
  clinic.trial(same, text, on_target(99.0), storage::TrialStatus::aborted);
  clinic.trial(same, kTask, on_target(99.0));
  EXPECT_EQ(Training::read(*clinic.store, now).value().level(task()), 0.4);
}

TEST(Training, TheBaselineIsTheMeanOfTheBestOfTheFirstTwoDays) {
  Clinic clinic;
  const auto add = [&](const std::string& utc, double force_N) {
    clinic.trial(clinic.session(utc, Hand::right, true), kTask,
                 measured("maximum_force", "grip", force_N));
  };
  add("2026-01-05T09:00:00Z", 10.0);
  add("2026-01-05T10:00:00Z", 14.0);
  add("2026-01-07T09:00:00Z", 20.0);
  add("2026-01-09T09:00:00Z", 99.0);
  const auto now = clinic.session("2026-01-12T09:00:00Z", Hand::right, true);
  const auto training = Training::read(*clinic.store, now).value();
  EXPECT_DOUBLE_EQ(training.baseline_N().at({}), 17.0);
}

TEST(Training, AMaximumOfAnOlderDefinitionFollowsAgainFromItsSignals) {
  constexpr double kForce_N = 12.0;
  Clinic clinic;
  const std::string text =
      "format = \"isograsp-task-1\"\nname = \"max\"\ninstruction = \"press\"\nkind = \"maximum\"\n";
  const auto add = [&](const std::string& utc) {
    const auto session = clinic.session(utc, Hand::right, true);
    storage::TrialRecord trial;
    trial.session_id = session.id;
    trial.number = 1;
    trial.task_name = "max";
    trial.task_text = text;
    trial.groups = {{"task", {"t_s", "phase", "actual_force_N", "resting_force_N"}}};
    trial.id = clinic.store->begin_trial(trial).value();
    Signals signals(trial.groups[0].columns);
    for (int second = 0; second < 3; ++second) {
      std::vector<double> rows;
      for (int k = 100 * second; k < 100 * (second + 1); ++k) {
        const std::vector row{0.01 * k, static_cast<double>(tasks::Phase::active), kForce_N, 0.0};
        signals.append_row(row);
        rows.insert(rows.end(), row.begin(), row.end());
      }
      const std::vector<std::vector<double>> block(1, rows);
      EXPECT_TRUE(clinic.store->append_blocks(trial.id, second, block).ok());
    }
    trial.samples = 300;
    trial.status = storage::TrialStatus::completed;
    auto measures = tasks::score(tasks::parse_task(text, "max").value(), signals);
    for (auto& measure : test::every(measures)) {
      if (measure.name != "maximum_force") continue;
      --measure.version;
      EXPECT_WITHIN(measure.value.value(), kForce_N, 1e-9);
      measure.value = 99.0;
    }
    EXPECT_TRUE(clinic.store->end_trial(trial, measures).ok());
  };
  add("2026-01-05T09:00:00Z");
  const auto now = clinic.session("2026-01-12T09:00:00Z", Hand::right, true);
  const auto training = Training::read(*clinic.store, now).value();
  EXPECT_WITHIN(training.baseline_N().at({}), kForce_N, 1e-9);
}

TEST(Training, ALevelChangesTheTaskAndStaysInItsText) {
  const auto easy = tasks::at_level(task(), 0.0).value();
  const auto hard = tasks::at_level(task(), 1.0).value();
  EXPECT_DOUBLE_EQ(easy.kind.as<tasks::ForceTrackingSpec>().waveform.frequency_Hz, 0.2);
  EXPECT_DOUBLE_EQ(hard.kind.as<tasks::ForceTrackingSpec>().waveform.frequency_Hz, 0.4);
  const auto again = tasks::parse_task(hard.text, "stored").value();
  EXPECT_EQ(again.difficulty->chosen, 1.0);
  EXPECT_DOUBLE_EQ(again.kind.as<tasks::ForceTrackingSpec>().waveform.frequency_Hz, 0.4);
}

}  // namespace
}  // namespace isograsp::session::training_test
