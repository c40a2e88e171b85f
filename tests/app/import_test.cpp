// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings that others made become patients, trials and a report; a bad file changes nothing.
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/within.hpp"

namespace isograsp::app::import_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

/// A whole database in memory.
struct Session {
  storage::SessionRecord record;
  std::vector<storage::TrialRecord> trials;
  std::vector<std::vector<Measure>> measures;
};
struct Patient {
  std::string code;
  std::vector<Session> sessions;
};
std::vector<Patient> all_of(storage::SessionStore& store) {
  std::vector<Patient> patients;
  for (const auto& found : store.patients().value()) {
    patients.push_back({found.code, {}});
    for (const auto& record : store.sessions(found.id).value()) {
      Session session{record, store.trials(record.id).value(), {}};
      for (const auto& trial : session.trials)
        session.measures.push_back(store.measures(trial.id).value());
      patients.back().sessions.push_back(std::move(session));
    }
  }
  return patients;
}
std::unique_ptr<storage::SessionStore> opened(const std::string& db) {
  return storage::open_store(db, storage::OpenMode::read_only).value();
}
double value_of(const std::vector<Measure>& measures, const std::string& name,
                const std::string& channel = "force") {
  for (const Measure& measure : measures)
    if (measure.name == name && measure.channel == channel && measure.value) return *measure.value;
  return std::nan("");
}

/// Two people, before and after, two trials of three rows each.
std::string recording(const std::string& more = "", const std::string& unit = "lbf") {
  return R"(format = "isograsp-recording-1"
name = "Two pushes"
label = "made up for a test"
source = "nowhere"
licence = "none needed"
device = "nothing"
file = "P{who}_{when}.csv"
separator = "comma"
header = true
time_column = "time"
rate_Hz = 2
patient_prefix = "TEST"
patient = "who"
session = "when"
sessions = ["before", "after"]
trial = ["task", "trial"]
unit_reason = "the header is wrong"
task = '''
format = "isograsp-task-1"
name = "Push {task}"
instruction = "Push."
kind = "recorded"
measures = "maximum"
window_from_end_rows = [2, 0]
duration_s = 1.5
'''
)" + more +
         "[[column]]\nname = \"actual_force_N\"\nfrom = [\"x [N]\", \"y [N]\"]\n"
         "combine = \"magnitude\"\nunit = \"" +
         unit + "\"\n";
}
std::string rows(double newtons, const std::string& extra = "") {
  std::string text = "task,trial,time,x [N],y [N]\r\n";
  for (const char* trial : {"hard,1", "hard,2"})
    for (const char* time : {"0", "0.4", "1"})
      text += std::string(trial) + "," + time + ", " + format_number(0.6 * newtons) + ",-" +
              format_number(0.8 * newtons) + "\r\n";
  return text + extra;
}
void write_people(const TemporaryFolder& folder) {
  folder.write("P10_after.csv", rows(4.0));
  folder.write("P2_after.csv", rows(2.0));
  folder.write("P2_before.csv", rows(1.0));
  folder.write("P10_before.csv", rows(3.0));
  folder.write("notes.txt", "not a recording");
}
test::CommandResult import(const TemporaryFolder& folder, const std::string& text) {
  folder.write("r.toml", text);
  return isograsp("import --recording " + folder.path("r.toml") + " --from " + folder.path() +
                  " --db " + folder.path("c.db"));
}

TEST(Import, FilesBecomePatientsSessionsInTheirOrderAndTrialsInSIUnits) {
  const TemporaryFolder folder;
  write_people(folder);
  const auto done = import(folder, recording());
  ASSERT_EQ(done.status, 0) << done.err;
  EXPECT_NE(done.out.find("2 patients, 4 sessions, 8 trials, 24 samples"), std::string::npos)
      << done.out;
  const auto store = opened(folder.path("c.db"));
  const auto patients = all_of(*store);
  ASSERT_EQ(patients.size(), 2u);
  EXPECT_EQ(patients[0].code, "TEST-02") << "by number, not by the letters of the file's name";
  EXPECT_EQ(patients[1].code, "TEST-10");
  double pounds = 0.0;
  for (const Patient& patient : test::every(patients)) {
    ASSERT_EQ(patient.sessions.size(), 2u);
    EXPECT_LT(patient.sessions[0].record.started_utc, patient.sessions[1].record.started_utc);
    for (const Session& session : test::every(patient.sessions)) {
      pounds += 1.0;
      EXPECT_TRUE(session.record.recorded);
      EXPECT_FALSE(session.record.simulated);
      ASSERT_EQ(session.trials.size(), 2u);
      for (std::size_t t = 0; t < 2; ++t) {
        const storage::TrialRecord& trial = session.trials[t];
        EXPECT_EQ(trial.status, storage::TrialStatus::completed);
        EXPECT_EQ(trial.task_name, "Push hard");
        const auto signals = store->signals(trial).value();
        ASSERT_EQ(signals.rows(), 3u);
        EXPECT_EQ(signals.column("t_s")[1], 0.4);
        EXPECT_WITHIN(signals.column("actual_force_N")[0], pounds * 4.4482216152605,
                      1e-12 * pounds);
        EXPECT_WITHIN(value_of(session.measures[t], "maximum_window_mean"),
                      pounds * 4.4482216152605, 1e-12 * pounds);
      }
    }
  }
  EXPECT_EQ(isograsp("db check " + folder.path("c.db")).status, 0);
  const auto verified = isograsp("db verify " + folder.path("c.db"));
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
}

TEST(Import, TheUnitChangesTheNumbersAndNothingElse) {
  const TemporaryFolder pounds;
  const TemporaryFolder newtons;
  write_people(pounds);
  write_people(newtons);
  ASSERT_EQ(import(pounds, recording()).status, 0);
  ASSERT_EQ(import(newtons, recording("", "N")).status, 0);
  const auto in_pounds = all_of(*opened(pounds.path("c.db")));
  const auto in_newtons = all_of(*opened(newtons.path("c.db")));
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t s = 0; s < 2; ++s)
      EXPECT_WITHIN(value_of(in_pounds[p].sessions[s].measures[0], "maximum_window_mean") /
                        value_of(in_newtons[p].sessions[s].measures[0], "maximum_window_mean"),
                    4.4482216152605, 1e-12);
}

TEST(Import, TheProvenanceSaysEverythingThatTheFilesDoNot) {
  const TemporaryFolder folder;
  write_people(folder);
  ASSERT_EQ(import(folder, recording("notes = [\"first\\nsecond\"]\n")).status, 0);
  const auto patients = all_of(*opened(folder.path("c.db")));
  const std::string& text = patients[0].sessions[1].record.provenance;
  EXPECT_EQ(text.find("made up for a test\n"), 0u) << text;
  for (const char* line :
       {"source: nowhere\n", "licence: none needed\n", "units: the header is wrong\n",
        "actual_force_N = magnitude of x [N], y [N], in lbf\n", "time is column time in s",
        "the hand is not known: stored as right\n", "the dates are not known", "session: after\n",
        "file: P2_after.csv\n", "note: first second\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
  EXPECT_EQ(text.find("P2_before.csv"), std::string::npos);
  EXPECT_EQ(patients[0].sessions[1].record.hand, Hand::right);

  const TemporaryFolder left;
  write_people(left);
  ASSERT_EQ(import(left, recording("hand = \"left\"\n")).status, 0);
  const auto known = all_of(*opened(left.path("c.db")));
  EXPECT_EQ(known[0].sessions[0].record.hand, Hand::left);
  EXPECT_EQ(known[0].sessions[0].record.provenance.find("the hand"), std::string::npos);
}

TEST(Import, ABadFileIsNamedWithLineAndFieldAndNoDatabaseIsMade) {
  for (const auto& [extra, message] :
       {std::pair<std::string, std::string>{"hard,3,0,1,2\r\nhard,3,0.5,1,much\r\n",
                                            ":9: y [N]: 'much' is not a finite number"},
        {"hard,3,0,1,2\r\nhard,3,0,1,2\r\n", ":9: time: time does not increase"},
        {"hard,3,0\r\n", ":8: has 3 fields"},
        {"hard,3,0,1,2\r\n", "a trial has fewer than two rows"}}) {
    const TemporaryFolder folder;
    write_people(folder);
    folder.write("P2_after.csv", rows(2.0, extra));
    const auto done = import(folder, recording());
    EXPECT_EQ(done.status, 2) << extra;
    EXPECT_NE(done.err.find("P2_after.csv"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find(message), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(folder.path("c.db")));
  }
}

TEST(Import, ARecordingFileThatDoesNotFitIsRefused) {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = recording();
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  for (const auto& [text, message] :
       {std::pair<std::string, std::string>{changed("unit_reason = \"the header is wrong\"\n", ""),
                                            "'x [N]' states"},
        {recording("", "stone"), "'stone' is not a unit"},
        {changed("actual_force_N", "actual_force"), "does not carry the SI unit"},
        {recording("colour = \"red\"\n"), "colour"},
        {changed("\"y [N]\"", "\"z [N]\""), "z [N]: the column is missing"},
        {changed("\"before\", ", ""), "'before' is none of the sessions"},
        {changed("patient = \"who\"", "patient = \"task\""), "'hard' is not the number"},
        {changed("[2, 0]", "[0, 2]"), "window_from_end_rows"},
        {changed("P{who}", "Q{who}"), "holds no file Q{who}_{when}.csv"},
        {changed("trial = [\"task\", \"trial\"]\n", ""), "time does not increase"}}) {
    const TemporaryFolder folder;
    write_people(folder);
    const auto done = import(folder, text);
    EXPECT_EQ(done.status, 2) << message;
    EXPECT_NE(done.err.find(message), std::string::npos) << done.err;
    EXPECT_FALSE(fs::exists(folder.path("c.db"))) << message;
  }
}

TEST(Import, ASecondImportOfTheSamePeopleIsRefusedAndChangesNothing) {
  const TemporaryFolder folder;
  write_people(folder);
  ASSERT_EQ(import(folder, recording()).status, 0);
  const auto again = import(folder, recording());
  EXPECT_EQ(again.status, 2);
  EXPECT_NE(again.err.find("TEST-02 exists already"), std::string::npos) << again.err;
  const auto patients = all_of(*opened(folder.path("c.db")));
  ASSERT_EQ(patients.size(), 2u);
  EXPECT_EQ(patients[0].sessions.size(), 2u);
}

TEST(Import, TheReportOfAPatientSaysThatItIsARecording) {
  const TemporaryFolder folder;
  write_people(folder);
  ASSERT_EQ(import(folder, recording()).status, 0);
  const auto report = isograsp("report --db " + folder.path("c.db") + " --patient TEST-02 --out " +
                               folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const auto html = read_text(folder.path("r.html")).value();
  for (const char* words : {"a replayed recording, not measured with this device",
                            "made up for a test", "Maximum force, mean over a fixed window"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

/// Forces that differ in every row and finger.
std::string forces_of_a_hand() {
  std::string text =
      "t_s,thumb_fz_N,index_fz_N,middle_fz_N,thumb_fx_N,index_fx_N,middle_fx_N,"
      "thumb_fy_N,index_fy_N,middle_fy_N\n";
  for (int k = 0; k < 300; ++k) {
    text += format_number(0.01 * k);
    for (int value = 0; value < 9; ++value)
      text += "," + format_number((value < 3 ? 5.0 : 0.1) + std::sin(0.02 * k + value));
    text += "\n";
  }
  return text;
}
const std::string kFreeHandling =
    " --task " ISOGRASP_SOURCE_DIR "/library/tasks/free_handling.toml --patient T-01 --db ";

TEST(Import, ForcesBecomeAStoredScoredTrialOfAPatient) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("forces.csv", forces_of_a_hand());
  const auto done =
      isograsp("import --hand left --forces " + forces + kFreeHandling + folder.path("c.db"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto store = opened(folder.path("c.db"));
  const auto patients = all_of(*store);
  ASSERT_EQ(patients.size(), 1u);
  const Session& session = patients[0].sessions.at(0);
  EXPECT_EQ(patients[0].code, "T-01");
  EXPECT_TRUE(session.record.recorded);
  EXPECT_EQ(session.record.hand, Hand::left);
  ASSERT_EQ(session.trials.size(), 1u);
  EXPECT_EQ(session.trials[0].status, storage::TrialStatus::completed);
  EXPECT_GT(session.measures[0].size(), 0u);
  const auto signals = store->signals(session.trials[0]).value();
  const auto given = read_signals(forces).value();
  ASSERT_EQ(signals.rows(), given.rows());
  for (std::size_t c = 1; c < given.names().size(); ++c)
    for (std::size_t row = 0; row < given.rows(); ++row)
      ASSERT_EQ(signals.column(given.names()[c])[row], given.column(c)[row]) << given.names()[c];
  EXPECT_TRUE(signals.has("actual_x_m"));
  EXPECT_EQ(isograsp("db verify " + folder.path("c.db")).status, 0);
}

TEST(Import, ExportedSignalsKeepTheirHandAndWhetherTheyWereSimulated) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("forces.csv", forces_of_a_hand());
  ASSERT_EQ(isograsp("import --hand left --forces " + forces + kFreeHandling + folder.path("c.db"))
                .status,
            0);
  const std::string out = folder.path("out");
  ASSERT_EQ(isograsp("export --db " + folder.path("c.db") + " --out " + out).status, 0);
  const std::string stem = out + "/patient_1/session_1/trial_1";
  const auto import_into = [&](const std::string& name, const std::string& more = "") {
    return isograsp("import --signals " + stem + "_signals.csv" + more + kFreeHandling +
                    folder.path(name));
  };
  const auto session_in = [&](const std::string& name) {
    const auto store = opened(folder.path(name));
    return all_of(*store).at(0).sessions.at(0).record;
  };
  ASSERT_EQ(import_into("again.db").status, 0);
  EXPECT_EQ(session_in("again.db").hand, Hand::left);
  EXPECT_TRUE(session_in("again.db").recorded);
  EXPECT_FALSE(session_in("again.db").simulated);

  const auto wrong = import_into("wrong.db", " --hand right");
  EXPECT_EQ(wrong.status, 2);
  EXPECT_NE(wrong.err.find("of the left hand"), std::string::npos) << wrong.err;

  auto sidecar = read_text(stem + ".json").value();
  const std::string real = "\"simulated\": false";
  ASSERT_NE(sidecar.find(real), std::string::npos);
  sidecar.replace(sidecar.find(real), real.size(), "\"simulated\": true");
  ASSERT_TRUE(write_text(stem + ".json", sidecar).ok());
  ASSERT_EQ(import_into("simulated.db").status, 0);
  EXPECT_TRUE(session_in("simulated.db").simulated);
  EXPECT_FALSE(session_in("simulated.db").recorded);

  ASSERT_TRUE(write_text(stem + ".json", "{\"format\": 7}").ok());
  const auto damaged = import_into("damaged.db");
  EXPECT_EQ(damaged.status, 2);
  EXPECT_NE(damaged.err.find("trial_1.json"), std::string::npos) << damaged.err;
}

/// candump of three RFT sensors at 100 Hz: every fz begins at 10 N and grows by a count (20 mN)
/// with every sample; all else is zero.
constexpr int kLogged = 200;
constexpr double kFirst_N = 10.0;
constexpr double kStep_N = 0.02;
std::string log_of_rising_forces() {
  std::string text;
  char line[80];
  for (int k = 0; k < kLogged; ++k)
    for (int finger = 0; finger < 3; ++finger) {
      const double t_s = 0.01 * k + 0.001 * finger;
      const int count = static_cast<int>(std::lround(kFirst_N / kStep_N)) + k;
      std::snprintf(line, sizeof line, "(%.6f) can0 %03X#0B00000000%04X00\n", 1.7e9 + t_s,
                    2 * finger + 1, static_cast<unsigned>(count));
      text += line;
      std::snprintf(line, sizeof line, "(%.6f) can0 %03X#0000000000000000\n", 1.7e9 + t_s + 0.0002,
                    2 * finger + 2);
      text += line;
    }
  return text;
}

TEST(Import, ARawLogBecomesATrialToo) {
  const TemporaryFolder folder;
  const auto done = isograsp("import --protocol rft --forces " +
                             folder.write("frames.log", log_of_rising_forces()) + kFreeHandling +
                             folder.path("c.db"));
  ASSERT_EQ(done.status, 0) << done.err;
  const auto store = opened(folder.path("c.db"));
  const auto patients = all_of(*store);
  const storage::TrialRecord& trial = patients.at(0).sessions.at(0).trials.at(0);
  EXPECT_EQ(trial.status, storage::TrialStatus::completed);
  const auto signals = store->signals(trial).value();
  EXPECT_GE(signals.rows(), static_cast<std::size_t>(kLogged) - 2);
  for (const std::string finger : {"thumb", "index", "middle"}) {
    // Mounting turns a force; its size stays.
    double before_N = kFirst_N;
    std::size_t valid = 0;
    for (std::size_t row = 0; row < signals.rows(); ++row) {
      const Vec3 force_C(signals.column(finger + "_fx_N")[row],
                         signals.column(finger + "_fy_N")[row],
                         signals.column(finger + "_fz_N")[row]);
      if (!std::isfinite(force_C[2])) continue;
      ++valid;
      constexpr double kRounding_N = 1e-9;
      EXPECT_GE(force_C.norm(), before_N - kRounding_N) << finger << " row " << row;
      before_N = force_C.norm();
    }
    EXPECT_GE(valid, static_cast<std::size_t>(kLogged) - 3) << finger;
    EXPECT_NEAR(before_N, kFirst_N + kStep_N * (kLogged - 1), 2.0 * kStep_N) << finger;
  }
}

TEST(Import, WhatIsMissingOnTheCommandLineIsNamed) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("forces.csv", forces_of_a_hand());
  const std::string to = " --db " + folder.path("c.db");
  for (const auto& [arguments, field] :
       {std::pair<std::string, std::string>{"", "give one of --recording, --forces, --signals"},
        {"--recording maximum_push", "--from"},
        {"--forces " + forces, "--task"},
        {"--signals " + forces + " --task t.toml", "--patient"},
        {"--signals " + forces + " --forces " + forces, "give one of"},
        {"--signals " + forces + " --task t.toml --patient T-01 --hand both", "--hand"},
        {"--signals " + forces + " --task none.toml --patient T-01", "none.toml"}}) {
    const auto refused = isograsp("import " + arguments + to);
    EXPECT_EQ(refused.status, 2) << arguments;
    EXPECT_NE(refused.err.find(field), std::string::npos) << arguments << ": " << refused.err;
    EXPECT_FALSE(fs::exists(folder.path("c.db"))) << arguments;
  }
}

/// Imports a shipped recording; false: the data are not on this machine.
bool import_shipped(const TemporaryFolder& folder, const std::string& name,
                    const std::string& data) {
  const std::string from = test::recorded_data() + "/" + data;
  if (!fs::is_directory(from)) return false;
  const auto done =
      isograsp("import --recording " + name + " --from " + from + " --db " + folder.path("c.db"));
  EXPECT_EQ(done.status, 0) << done.err;
  return done.status == 0;
}

TEST(Import, EveryShippedRecordingFileIsSound) {
  int files = 0;
  for (const auto& entry :
       test::every(fs::directory_iterator(ISOGRASP_SOURCE_DIR "/library/recordings"))) {
    const TemporaryFolder empty;
    const auto done = isograsp("import --recording " + entry.path().string() + " --from " +
                               empty.path() + " --db " + empty.path("c.db"));
    // The folder is empty: the file itself was accepted before that was seen.
    EXPECT_NE(done.err.find("holds no file"), std::string::npos) << done.err;
    ++files;
  }
  EXPECT_EQ(files, 3);
}

TEST(ImportedPeople, GripInACorridorIsScoredWithTheTimeThatRowsHold) {
  const TemporaryFolder folder;
  if (!import_shipped(folder, "grip_tracking", "edraki-grip-tracking")) GTEST_SKIP() << "no data";
  const auto store = opened(folder.path("c.db"));
  const auto patients = all_of(*store);
  EXPECT_EQ(patients.size(), 4u) << "of the seven people the file holds the first four";
  std::size_t trials = 0;
  std::size_t differing = 0;
  std::set<std::string> tasks;
  for (const Patient& patient : test::every(patients))
    for (const Session& session : test::every(patient.sessions))
      for (std::size_t t = 0; t < session.trials.size(); ++t) {
        ++trials;
        tasks.insert(session.trials[t].task_name);
        const auto signals = store->signals(session.trials[t]).value();
        EXPECT_EQ(signals.rows(), 294u);
        double squares = 0.0;
        double inside = 0.0;
        for (const double error_N : signals.column("corridor_error_N")) {
          squares += error_N * error_N;
          inside += error_N == 0.0 ? 1.0 : 0.0;
        }
        const double by_rows_N = std::sqrt(squares / 294.0);
        const double by_time_N = value_of(session.measures[t], "corridor_rms");
        EXPECT_GE(by_time_N, value_of(session.measures[t], "corridor_distance"));
        differing += by_time_N != by_rows_N ? 1 : 0;
        // The steps jitter by less than a factor of three.
        EXPECT_NEAR(by_time_N, by_rows_N, 0.5 * by_rows_N);
        EXPECT_NEAR(value_of(session.measures[t], "time_in_corridor"), inside / 2.94, 10.0);
      }
  EXPECT_EQ(trials, 117u);
  EXPECT_EQ(tasks.size(), 6u);
  EXPECT_GT(differing, 100u) << "steps of 10 and of 25 ms do not count alike";
}

TEST(ImportedPeople, TheWiderTheCorridorTheLongerThePeopleAreInIt) {
  const TemporaryFolder folder;
  if (!import_shipped(folder, "grip_tracking", "edraki-grip-tracking")) GTEST_SKIP() << "no data";
  std::map<std::string, std::pair<double, int>> of_task;
  for (const Patient& patient : all_of(*opened(folder.path("c.db"))))
    for (const Session& session : patient.sessions)
      for (std::size_t t = 0; t < session.trials.size(); ++t) {
        auto& [sum, count] = of_task[session.trials[t].task_name];
        sum += value_of(session.measures[t], "time_in_corridor");
        ++count;
      }
  const auto mean = [&](const std::string& grasp, const char* difficulty) {
    const auto& [sum, count] = of_task.at(grasp + " grip in a corridor, " + difficulty);
    return sum / count;
  };
  for (const char* grasp : {"Pinch", "Power"}) {
    EXPECT_GT(mean(grasp, "Easy"), mean(grasp, "Medium")) << grasp;
    EXPECT_GT(mean(grasp, "Medium"), mean(grasp, "Hard")) << grasp;
  }
}

TEST(ImportedPeople, MaximumPushesBeforeAndAfterAreThePublishedOnes) {
  const TemporaryFolder folder;
  if (!import_shipped(folder, "maximum_push", "tessari-gimbal")) GTEST_SKIP() << "no data";
  // With the authors' rows and factors, to a tenth of a newton.
  constexpr double kBefore_N[] = {103.9, 120.2, 81.7, 137.8, 135.3};
  constexpr double kAfter_N[] = {128.1, 139.7, 93.6, 137.4, 162.4};
  constexpr double kPrinted_N = 0.05 + 1e-3;  // half of the last digit; factors cut to six digits
  const auto patients = all_of(*opened(folder.path("c.db")));
  ASSERT_EQ(patients.size(), 5u);
  for (std::size_t p = 0; p < 5; ++p) {
    ASSERT_EQ(patients[p].sessions.size(), 2u);
    const auto& [before, after] = std::tie(patients[p].sessions[0], patients[p].sessions[1]);
    EXPECT_WITHIN(value_of(before.measures.at(0), "maximum_window_mean"), kBefore_N[p], kPrinted_N);
    EXPECT_WITHIN(value_of(after.measures.at(0), "maximum_window_mean"), kAfter_N[p], kPrinted_N);
  }
  const auto report = isograsp("report --db " + folder.path("c.db") +
                               " --patient TESSARI-01 --out " + folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const auto html = read_text(folder.path("r.html")).value();
  for (const char* words : {"a replayed recording", "push a handle with the whole arm",
                            "the numbers are lbf", "REPLAYED RECORDING"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
}

TEST(ImportedPeople, FourFingersKeepTheMetronomesRhythmAndShareTheForce) {
  const TemporaryFolder folder;
  if (!import_shipped(folder, "finger_press", "ucm-finger-press")) GTEST_SKIP() << "no data";
  const auto patients = all_of(*opened(folder.path("c.db")));
  ASSERT_EQ(patients.size(), 1u);
  const auto& measures = patients[0].sessions.at(0).measures.at(0);
  constexpr double kLine_Hz = 1.0 / 30.0;  // of a spectrum of the whole recording
  EXPECT_WITHIN(value_of(measures, "rhythm"), 1.0 / 1.5, 0.5 * kLine_Hz);
  double shares = 0.0;
  double before = 100.0;
  for (const char* finger : {"index", "middle", "ring", "little"}) {
    const double share = value_of(measures, "sharing", finger);
    EXPECT_LT(share, before) << finger << ": from index to little they press less";
    shares += before = share;
  }
  EXPECT_WITHIN(shares, 100.0, 1e-10);
  const double index = value_of(measures, "synergy_index");
  EXPECT_GT(index, -4.0);
  EXPECT_LT(index, 4.0 / 3.0);
  EXPECT_GT(value_of(measures, "variance_within"), 0.0);
}

}  // namespace
}  // namespace isograsp::app::import_test
