// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <signal.h>

#include "core/csv.hpp"
#include "hand/finger_forces.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/command.hpp"
#include "tests/support/recorded_data.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::app::run_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

const std::string kProtocols = std::string(ISOGRASP_SOURCE_DIR) + "/library/protocols/";

TEST(CommandLine, AnErrorIsOneLineThatNamesTheCauseAndTheStatusIsTwo) {
  const TemporaryFolder folder;
  const std::string good = "--protocol-file " + kProtocols +
                           "short.toml --device sim://healthy --db " + folder.path("c.db") +
                           " --patient T-01 --fast";
  for (const auto& [arguments, message] :
       {std::pair<std::string, std::string>{"frobnicate", "frobnicate"},
        {"run", "--protocol-file is required"},
        {"run " + good + " --hand both", "--hand: 'both' is not a hand"},
        {"run " + good + " --realtime=sometimes", "sometimes"},
        {"run --protocol-file absent.toml --device sim://healthy --db " + folder.path("c.db") +
             " --patient T-01",
         "absent.toml"},
        {"run --protocol-file " + kProtocols + "short.toml --device sim://healthy --db " +
             folder.path("c.db") + " --patient 'Anna Maria' --fast",
         "patient code"},
        {"run --protocol-file " + kProtocols + "short.toml --device warp://core --db " +
             folder.path("d.db") + " --patient T-01 --fast",
         "warp"}}) {
    const auto result = isograsp(arguments);
    EXPECT_EQ(result.status, 2) << arguments << "\n" << result.err;
    EXPECT_EQ(result.err.find("isograsp: "), 0u) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_TRUE(result.out.empty()) << result.out;
  }
  EXPECT_FALSE(fs::exists(folder.path("d.db")));
  EXPECT_FALSE(fs::exists(folder.path("c.db"))) << "nothing may be made before the input is good";
}

TEST(CommandLine, WhatWasDoneInATrialBecomesATargetThatCanBeRun) {
  const TemporaryFolder folder;
  const std::string head =
      "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\nkind = "
      "\"instrument_zero\"\n[[step]]\nkind = \"task\"\ntask = ";
  const auto run = [&](const std::string& task) {
    return isograsp("run --protocol-file " + folder.write("p.toml", head + task) +
                    " --device 'sim://healthy?seed=3' --db " + folder.path("c.db") +
                    " --patient P-1 --fast");
  };
  ASSERT_EQ(run("\"pose_tracking_x.toml\"\n").status, 0);
  const std::string target = "target --db " + folder.path("c.db") +
                             " --patient P-1 --name Mine --out " + folder.path("mine.toml");
  EXPECT_NE(isograsp(target + " --trial 2").err.find("this session has 1 trials"),
            std::string::npos);
  const auto made = isograsp(target);
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_NE(isograsp(target).err.find("exists already"), std::string::npos);
  const auto again = run("\"mine.toml\"\n");
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_NE(again.out.find("Trial 1  Mine  [completed]"), std::string::npos) << again.out;
}

TEST(CommandLine, HelpAndVersionSucceedOnEverySubcommand) {
  EXPECT_EQ(isograsp("--version").status, 0);
  const auto help = isograsp("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* name :
       {"convert", "db", "decode", "devices", "emulate", "export", "grasp", "gui", "import",
        "monitor", "record", "report", "run", "score", "simulate", "target"}) {
    EXPECT_NE(help.out.find(name), std::string::npos) << name;
    const auto own = isograsp(std::string(name) + " --help");
    EXPECT_EQ(own.status, 0) << name;
    EXPECT_NE(own.out.find("xample"), std::string::npos) << name << " shows no example";
  }
}

TEST(CommandLine, ASessionIsRecordedScoredExportedAndReported) {
  const TemporaryFolder folder;
  const std::string db = folder.path("c.db");
  const auto run =
      isograsp("run --protocol-file " + kProtocols +
               "short.toml --device 'sim://healthy?seed=4' --db " + db + " --patient T-01 --fast");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("patient T-01 is new"), std::string::npos) << run.err;
  EXPECT_NE(run.out.find("maximum_force"), std::string::npos) << run.out;
  EXPECT_EQ(isograsp("db check " + db).status, 0);
  EXPECT_EQ(isograsp("db verify " + db).status, 0);

  const auto report =
      isograsp("report --db " + db + " --patient T-01 --out " + folder.path("r.pdf"));
  EXPECT_EQ(report.status, 0) << report.err;
  EXPECT_EQ(report.err, "") << "no word of the libraries below";
  EXPECT_GT(fs::file_size(folder.path("r.pdf")), 10000u);

  const auto exported = isograsp("export --db " + db + " --format csv --out " + folder.path("x"));
  ASSERT_EQ(exported.status, 0) << exported.err;
}

/// Forces of a hand that grips, moves and lets go, on a regular grid, with gaps of one sample.
std::string some_forces() {
  std::string text;
  for (const auto& name : finger_forces_columns()) text += (text.empty() ? "" : ",") + name;
  text += "\n";
  for (int k = 0; k < 500; ++k) {
    FingerForcesRow row;
    row.t_s = k * 0.01;
    for (std::size_t f = 0; f < kFingerCount; ++f) {
      row.present[f] = k % 97 != 40 + static_cast<int>(f);
      row.wrench_C[f].force = Vec3(std::sin(0.03 * k), 0.3 * std::cos(0.05 * k),
                                   4.0 + 3.0 * std::sin(0.01 * k + static_cast<double>(f)));
    }
    append_finger_forces(text, row);
  }
  return text;
}

TEST(CommandLine, AReplayedSessionMovesTheObjectAsSimulateDoesBitForBit) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("forces.csv", some_forces());
  const std::string db = folder.path("c.db");
  const auto run =
      isograsp("run --protocol-file " + kProtocols + "recorded.toml --device replay://" + forces +
               " --db " + db + " --patient T-01 --fast");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto simulate =
      isograsp("simulate --scene " ISOGRASP_SOURCE_DIR "/library/scenes/firm_block.toml --forces " +
               forces + " --out " + folder.path("path.csv"));
  ASSERT_EQ(simulate.status, 0) << simulate.err;
  const auto path = read_signals(folder.path("path.csv")).value();

  const auto store = storage::open_store(db, storage::OpenMode::read_only).value();
  const auto patient = store->find_patient("T-01").value().value();
  const auto trial = store->trials(store->sessions(patient.id).value().at(0).id).value().at(0);
  const auto recorded = store->signals(trial).value();
  ASSERT_EQ(recorded.rows() + 1, path.rows()) << "simulate adds the end of the last hold";
  for (const auto& [ours, theirs] : {std::pair{"actual_x_m", "x_m"},
                                     {"actual_y_m", "y_m"},
                                     {"actual_qw", "qw"},
                                     {"actual_qz", "qz"},
                                     {"vx_mps", "vx_mps"},
                                     {"wz_radps", "wz_radps"},
                                     {"tz_Nm", "tz_Nm"}})
    for (std::size_t row = 0; row < recorded.rows(); ++row)
      ASSERT_EQ(recorded.column(ours)[row], path.column(theirs)[row]) << ours << " row " << row;
}

TEST(CommandLine, ARecordingThatPeopleMadeBecomesAReportThatSaysSo) {
  const std::string data = test::recorded_data();
  if (!fs::is_directory(data + "/kth-handover")) GTEST_SKIP() << "no recorded data in " << data;
  const TemporaryFolder folder;
  const auto convert = isograsp("convert --mapping kth_handover --input " + data +
                                "/kth-handover --out " + folder.path("k.csv"));
  ASSERT_EQ(convert.status, 0) << convert.err;
  const std::string db = folder.path("c.db");
  const auto run =
      isograsp("run --protocol-file " + kProtocols + "recorded.toml --device replay://" +
               folder.path("k.csv") + " --db " + db + " --patient T-02 --fast");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto report =
      isograsp("report --db " + db + " --patient T-02 --out " + folder.path("r.html"));
  ASSERT_EQ(report.status, 0) << report.err;
  const auto html = read_text(folder.path("r.html")).value();
  EXPECT_NE(html.find("stand-in: two people hand over a baton"), std::string::npos);
  EXPECT_NE(html.find("stated by the mapping: rate 120 Hz"), std::string::npos);
}

TEST(CommandLine, AKilledSessionIsThereUpToTheLastFullSecondAndMarkedInterrupted) {
  const TemporaryFolder folder;
  const std::string db = folder.path("c.db");
  const std::string command = "\"" ISOGRASP_EXECUTABLE "\" run --protocol-file " + kProtocols +
                              "demonstration.toml --device sim://healthy --db " + db +
                              " --patient T-01 >/dev/null 2>&1 & echo $! >" + folder.path("pid");
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto seconds_stored = [&db] {
    const auto store = storage::open_store(db, storage::OpenMode::read_only);
    if (!store) return std::int64_t{0};
    const auto patient = (*store)->find_patient("T-01");
    if (!patient || !*patient) return std::int64_t{0};
    const auto sessions = (*store)->sessions((*patient)->id).value();
    if (sessions.empty()) return std::int64_t{0};
    const auto trials = (*store)->trials(sessions[0].id).value();
    return trials.empty() ? 0 : trials[0].samples / 100;
  };
  // The first trial lasts ten seconds in real time: it is killed after two of them are stored.
  while (seconds_stored() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  pid_t pid = 0;
  std::ifstream(folder.path("pid")) >> pid;
  ASSERT_EQ(kill(pid, SIGKILL), 0);
  // The system needs a moment to take the process apart; then whoever looks next marks the trial.
  const auto status = [&db] {
    const auto opened = storage::open_store_to_read(db).value();
    const auto owner = opened->find_patient("T-01").value().value();
    return opened->trials(opened->sessions(owner.id).value().at(0).id).value().at(0).status;
  };
  for (int tries = 0; tries < 100 && status() == storage::TrialStatus::running; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));

  const auto store = storage::open_store(db, storage::OpenMode::existing).value();
  EXPECT_TRUE(store->check().value().empty());
  const auto patient = store->find_patient("T-01").value().value();
  const auto trials = store->trials(store->sessions(patient.id).value().at(0).id).value();
  ASSERT_EQ(trials.size(), 1u);
  EXPECT_EQ(trials[0].status, storage::TrialStatus::interrupted);
  const auto signals = store->signals(trials[0]).value();
  EXPECT_GE(signals.rows(), 200u);
  EXPECT_EQ(signals.rows() % 100, 0u) << "whole seconds";
}

TEST(CommandLine, AnInputIsNeverOverwrittenAndAFileWithoutFramesIsNoLog) {
  const TemporaryFolder folder;
  const std::string forces = folder.write("forces.csv", some_forces());
  const std::string scene = ISOGRASP_SOURCE_DIR "/library/scenes/firm_block.toml";
  const auto same =
      isograsp("simulate --scene " + scene + " --forces " + forces + " --out " + forces);
  EXPECT_EQ(same.status, 2);
  EXPECT_NE(same.err.find("is the input"), std::string::npos) << same.err;
  EXPECT_EQ(read_text(forces).value(), some_forces());
  const auto no_log =
      isograsp("decode --protocol rft " + forces + " --out " + folder.path("d.csv"));
  EXPECT_EQ(no_log.status, 2);
  EXPECT_NE(no_log.err.find("holds no frame"), std::string::npos) << no_log.err;
  EXPECT_FALSE(fs::exists(folder.path("d.csv")));
}

TEST(WholeDemonstration, GoesFromForceToReportWithoutAQuestion) {
  const TemporaryFolder folder;
  const test::Variable data("XDG_DATA_HOME", folder.path());
  const auto demo = isograsp("demo --headless");
  ASSERT_EQ(demo.status, 0) << demo.err;
  const auto at = demo.out.rfind("Report:");
  ASSERT_NE(at, std::string::npos) << demo.out;
  std::string pdf = demo.out.substr(demo.out.find('/', at));
  pdf.pop_back();  // the end of the line
  EXPECT_EQ(read_text(pdf).value().substr(0, 5), "%PDF-");
  EXPECT_EQ(isograsp("demo --headless").status, 0) << "safe to repeat";
}

}  // namespace
}  // namespace isograsp::app::run_test
