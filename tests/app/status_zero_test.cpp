// SPDX-License-Identifier: GPL-3.0-or-later
// Status 0 is true: whatever is done to the files while a session is recorded, what was completed
// can be read by another program, from the database or from an emergency file; and if anything is
// not in the database the status says so.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include "core/csv.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/command.hpp"
#include "tests/support/every.hpp"

namespace isograsp::app::status_zero_test {
namespace {

namespace fs = std::filesystem;
using test::isograsp;
using test::TemporaryFolder;

constexpr std::int64_t kSecond = 100;  // samples

/// Zero, a trial of two seconds, one that lasts until the fault strikes in it, however slow the
/// machine.
void write_protocol(const TemporaryFolder& folder) {
  const auto task = [&](const char* name, int seconds) {
    static_cast<void>(folder.write(
        name,
        "format = \"isograsp-task-1\"\nname = \"Free handling\"\n"
        "instruction = \"Move.\"\nversion = 1\nkind = \"observe\"\nscene = \"firm_block\"\n"
        "duration_s = " +
            std::to_string(seconds) + "\n"));
  };
  task("first.toml", 2);
  task("second.toml", 60);
  static_cast<void>(folder.write(
      "p.toml",
      "format = \"isograsp-protocol-1\"\nname = \"P\"\n[[step]]\nkind = \"instrument_zero\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"first.toml\"\n"
      "[[step]]\nkind = \"task\"\ntask = \"second.toml\"\n"));
}

/// The newest session of a file, as a program that comes afterwards reads it.
std::vector<storage::TrialRecord> trials_in(storage::SessionStore& store) {
  const auto sessions = store.recent_sessions(1);
  if (!sessions || sessions->empty()) return {};
  auto trials = store.trials(sessions->front().id);
  return trials ? *trials : std::vector<storage::TrialRecord>{};
}

/// The executable, recording in real time into a file of its own.
class RecordingRun {
 public:
  explicit RecordingRun(const std::string& before = "", const std::string& place = "") {
    write_protocol(folder);
    db = place.empty() ? folder.path("clinic.db") : place;
    const std::string command =
        "{ " + before + " XDG_STATE_HOME=" + folder.path("state") +
        " \"" ISOGRASP_EXECUTABLE "\" run --protocol-file " + folder.path("p.toml") +
        " --device 'sim://healthy?seed=3' --db " + db + " --patient T-01 >" + folder.path("out") +
        " 2>" + folder.path("err") + " </dev/null & echo $! >" + folder.path("pid") +
        "; wait $!; echo $? >" + folder.path("part") + "; mv " + folder.path("part") + " " +
        folder.path("status") + "; } &";
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
  /// The second trial is under way, the first one was completed.
  [[nodiscard]] bool ready() {
    if (finished()) return true;
    const auto store = storage::open_store(db, storage::OpenMode::read_only);
    if (!store) return false;
    const std::string backup = folder.path("backup.db");
    if (!fs::exists(backup) && !(*store)->backup(backup).ok()) return false;
    const auto trials = trials_in(**store);
    if (trials.size() < 2 || trials[1].samples < kSecond) return false;
    first = trials[0];
    second = trials[1];
    return true;
  }
  [[nodiscard]] bool finished() const { return fs::exists(folder.path("status")); }
  [[nodiscard]] int status() const {
    int status = -1;
    std::ifstream(folder.path("status")) >> status;
    return status;
  }
  [[nodiscard]] pid_t pid() const {
    pid_t pid = 0;
    std::ifstream(folder.path("pid")) >> pid;
    return pid;
  }
  [[nodiscard]] std::string said(const char* where) const {
    return read_text(folder.path(where)).value();
  }
  [[nodiscard]] std::vector<std::string> emergency_files() const {
    std::vector<std::string> files;
    std::error_code ignored;
    for (const auto& entry :
         fs::directory_iterator(folder.path("state") + "/isograsp/emergency", ignored))
      if (entry.path().extension() == ".db") files.push_back(entry.path());
    return files;
  }
  [[nodiscard]] test::CommandResult rescue(const std::string& options = "") const {
    return test::run("XDG_STATE_HOME=" + folder.path("state") +
                     " \"" ISOGRASP_EXECUTABLE "\" db rescue " + db + options);
  }

  TemporaryFolder folder;
  std::string db;
  storage::TrialRecord first;  ///< as it was before the fault
  storage::TrialRecord second;
};

/// Both trials, with the signals and measures that they had when they were confirmed.
void expect_kept(const std::string& path, const RecordingRun& run, const std::string& name) {
  const auto store = storage::open_store(path, storage::OpenMode::read_only);
  ASSERT_TRUE(store.ok()) << name << ": " << store.error().message();
  const auto trials = trials_in(**store);
  ASSERT_EQ(trials.size(), 2u) << name;
  EXPECT_EQ(trials[0].uuid, run.first.uuid) << name;
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed) << name;
  EXPECT_EQ(trials[0].samples, run.first.samples) << name;
  EXPECT_EQ(trials[0].signals_hash, run.first.signals_hash) << name;
  EXPECT_FALSE((*store)->measures(trials[0].id).value().empty()) << name;
  EXPECT_EQ(trials[1].uuid, run.second.uuid) << name;
  EXPECT_GE(trials[1].samples, run.second.samples) << name;
  for (const storage::TrialRecord& trial : test::every(trials)) {
    const auto signals = (*store)->signals(trial);
    ASSERT_TRUE(signals.ok()) << name << ": " << signals.error().message();
    EXPECT_EQ(static_cast<std::int64_t>(signals->rows()), trial.samples) << name;
  }
}

void wait_until(const std::function<bool()>& condition) {
  constexpr int kTries = 3000;
  for (int tries = 0; tries < kTries && !condition(); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

struct Fault {
  const char* name;
  std::function<void(const RecordingRun&)> strike;
  const char* words;  ///< on standard error
  /// What a person does to have the file back.
  std::function<void(const RecordingRun&)> mend;
};

void restore_backup(const RecordingRun& run) {
  fs::remove(run.db + "-wal");
  fs::remove(run.db + "-shm");
  fs::copy_file(run.folder.path("backup.db"), run.db, fs::copy_options::overwrite_existing);
}

const Fault kFaults[]{
    {"deleted", [](const RecordingRun& run) { fs::remove(run.db); }, "was deleted or moved away",
     [](const RecordingRun&) {}},
    {"moved", [](const RecordingRun& run) { fs::rename(run.db, run.db + ".away"); },
     "was deleted or moved away",
     [](const RecordingRun& run) { fs::rename(run.db + ".away", run.db); }},
    {"moved, a link in its place",
     [](const RecordingRun& run) {
       fs::rename(run.db, run.db + ".away");
       fs::create_symlink(run.db + ".away", run.db);
     },
     "another file was put in its place",
     [](const RecordingRun& run) { fs::rename(run.db + ".away", run.db); }},
    {"emptied", [](const RecordingRun& run) { fs::resize_file(run.db, 0); }, "was emptied",
     restore_backup},
    {"cut off", [](const RecordingRun& run) { fs::resize_file(run.db, fs::file_size(run.db) / 2); },
     "was cut off", restore_backup},
    {"overwritten", [](const RecordingRun& run) { std::ofstream(run.db) << "something else\n"; },
     "was overwritten", restore_backup},
    {"overwritten with a backup",
     [](const RecordingRun& run) {
       fs::copy_file(run.folder.path("backup.db"), run.db, fs::copy_options::overwrite_existing);
     },
     "while it was open", restore_backup},
    {"replaced",
     [](const RecordingRun& run) {
       fs::copy_file(run.folder.path("backup.db"), run.db + ".new");
       fs::rename(run.db + ".new", run.db);
     },
     "another file was put in its place", [](const RecordingRun&) {}},
    {"log deleted", [](const RecordingRun& run) { fs::remove(run.db + "-wal"); }, "(-wal)",
     [](const RecordingRun&) {}},
    {"log cut off", [](const RecordingRun& run) { fs::resize_file(run.db + "-wal", 0); }, "(-wal)",
     restore_backup},
    {"lock deleted", [](const RecordingRun& run) { fs::remove(run.db + "-lock"); }, "(-lock)",
     [](const RecordingRun&) {}},
    {"lock deleted and the file opened by another program",
     [](const RecordingRun& run) {
       fs::remove(run.db + "-lock");
       EXPECT_EQ(isograsp("db check " + run.db).status, 0);
     },
     "(-lock)", [](const RecordingRun&) {}},
};

TEST(StatusZero, WhateverIsDoneToTheFilesOfASessionNothingThatWasCompletedIsLostOrCalledStored) {
  std::vector<std::unique_ptr<RecordingRun>> runs;
  for (std::size_t at = 0; at < std::size(kFaults); ++at)
    runs.push_back(std::make_unique<RecordingRun>());
  for (std::size_t at = 0; at < std::size(kFaults); ++at) {
    RecordingRun& run = *runs[at];
    wait_until([&] { return run.ready(); });
    ASSERT_FALSE(run.finished()) << kFaults[at].name << ": " << run.said("err");
    kFaults[at].strike(run);
  }
  for (std::size_t at = 0; at < std::size(kFaults); ++at) {
    const Fault& fault = kFaults[at];
    const RecordingRun& run = *runs[at];
    wait_until([&] { return run.finished(); });
    const std::string err = run.said("err");
    EXPECT_EQ(run.status(), 1) << fault.name << ": " << err;
    EXPECT_NE(err.find(run.db + ": "), std::string::npos) << fault.name << ": " << err;
    EXPECT_NE(err.find(fault.words), std::string::npos) << fault.name << ": " << err;
    EXPECT_NE(err.find("isograsp db rescue " + run.db), std::string::npos) << err;
    EXPECT_EQ(run.said("out").find("[completed]"), std::string::npos) << fault.name;
    const auto files = run.emergency_files();
    ASSERT_EQ(files.size(), 1u) << fault.name << ": " << err;
    expect_kept(files[0], run, std::string(fault.name) + ", emergency file");
    EXPECT_EQ(fs::status(files[0]).permissions() & (fs::perms::group_all | fs::perms::others_all),
              fs::perms::none);

    fault.mend(run);
    const std::string copy = files[0] + ".copy.db";
    fs::copy_file(files[0], copy);
    const auto listed = run.rescue(" --list");
    EXPECT_NE(listed.out.find("T-01"), std::string::npos) << fault.name << ": " << listed.out;
    EXPECT_EQ(std::count(listed.out.begin(), listed.out.end(), '\n'), 2)
        << "one line for each session: " << listed.out;
    fs::remove(copy);
    const auto rescued = run.rescue();
    EXPECT_EQ(rescued.status, 0) << fault.name << ": " << rescued.err;
    expect_kept(run.db, run, std::string(fault.name) + ", rescued");
    EXPECT_EQ(isograsp("db check " + run.db).status, 0) << fault.name;
    EXPECT_TRUE(run.emergency_files().empty()) << fault.name;
    EXPECT_EQ(run.rescue().status, 0) << fault.name << ": nothing is left to be done";
  }
}

TEST(StatusZero, ASignalEndsTrialAndSessionAndNothingIsLost) {
  constexpr std::pair<int, const char*> kSignals[]{
      {SIGINT, "SIGINT"}, {SIGTERM, "SIGTERM"}, {SIGHUP, "SIGHUP"}};
  std::vector<std::unique_ptr<RecordingRun>> runs;
  // A shell gives its children in the background no SIGINT.
  for (std::size_t at = 0; at < std::size(kSignals); ++at)
    runs.push_back(std::make_unique<RecordingRun>());
  for (std::size_t at = 0; at < std::size(kSignals); ++at) {
    wait_until([&] { return runs[at]->ready(); });
    ASSERT_FALSE(runs[at]->finished()) << runs[at]->said("err");
    ASSERT_EQ(kill(runs[at]->pid(), kSignals[at].first), 0);
  }
  for (std::size_t at = 0; at < std::size(kSignals); ++at) {
    const RecordingRun& run = *runs[at];
    wait_until([&] { return run.finished(); });
    const std::string err = run.said("err");
    EXPECT_EQ(run.status(), 1) << err;
    EXPECT_NE(err.find(kSignals[at].second), std::string::npos) << err;
    EXPECT_NE(err.find(run.db), std::string::npos) << err;
    expect_kept(run.db, run, kSignals[at].second);
    const auto store = storage::open_store(run.db, storage::OpenMode::read_only).value();
    EXPECT_EQ(trials_in(*store).at(1).status, storage::TrialStatus::aborted);
    EXPECT_FALSE(store->recent_sessions(1).value().at(0).ended_utc.empty());
    EXPECT_EQ(isograsp("db check " + run.db).status, 0);
    EXPECT_TRUE(run.emergency_files().empty());
  }
}

TEST(StatusZero, AFileThatMayNotGrowIsAnErrorWithASentenceAndWhatWasConfirmedStays) {
  // In blocks of 512 bytes: the log reaches it in the second trial or before.
  RecordingRun run("ulimit -f 800;");
  wait_until([&] { return run.finished() || run.ready(); });
  wait_until([&] { return run.finished(); });
  const std::string err = run.said("err");
  EXPECT_EQ(run.status(), 1) << err;
  EXPECT_NE(err.find("RLIMIT_FSIZE"), std::string::npos) << err;
  EXPECT_NE(err.find(run.db), std::string::npos) << err;
  EXPECT_EQ(run.said("out").find("[completed]"), std::string::npos);
  EXPECT_EQ(isograsp("db check " + run.db).status, 0);
  const auto store = storage::open_store(run.db, storage::OpenMode::read_only).value();
  for (const storage::TrialRecord& trial : test::every(trials_in(*store)))
    EXPECT_TRUE(store->signals(trial).ok());
}

TEST(StatusZero, ASessionOnAFullDiskGoesIntoTheEmergencyFile) {
  const TemporaryFolder place;
  if (mount("tmpfs", place.path().c_str(), "tmpfs", 0, "size=1200k") != 0)
    GTEST_SKIP() << "no file system may be mounted here";
  {
    RecordingRun run("", place.path("clinic.db"));
    wait_until([&] { return run.ready(); });
    std::ofstream(place.path("filler")) << std::string(2 << 20, 'x');
    wait_until([&] { return run.finished(); });
    const std::string err = run.said("err");
    EXPECT_EQ(run.status(), 1) << err;
    EXPECT_NE(err.find("the disk is full"), std::string::npos) << err;
    ASSERT_EQ(run.emergency_files().size(), 1u) << err;
    expect_kept(run.emergency_files()[0], run, "full disk");
    fs::remove(place.path("filler"));
    // Two megabytes are more than it has; the session itself is smaller.
    mount("tmpfs", place.path().c_str(), "tmpfs", MS_REMOUNT, "size=20m");
    const auto rescued = run.rescue();
    EXPECT_EQ(rescued.status, 0) << rescued.err;
    expect_kept(run.db, run, "full disk, rescued");
  }
  umount2(place.path().c_str(), MNT_DETACH);
}

TEST(StatusZero, ATrialThatIsReadBackOtherThanItWasRecordedIsNotCalledCompleted) {
  const TemporaryFolder folder;
  const std::string db = folder.path("clinic.db");
  write_protocol(folder);
  ASSERT_EQ(isograsp("db init " + db).status, 0);
  // What the disk or another program might do to a trial, between its end and the reading back.
  ASSERT_EQ(test::run("sqlite3 " + db +
                      " \"CREATE TRIGGER other AFTER INSERT ON signal_packs BEGIN UPDATE "
                      "signal_packs SET float64_shuffled_zstd = "
                      "zeroblob(length(float64_shuffled_zstd)) WHERE rowid = new.rowid; END\"")
                .status,
            0);
  const std::string state = "XDG_STATE_HOME=" + folder.path("state") + " ";
  const auto ended =
      test::run(state + "\"" ISOGRASP_EXECUTABLE "\" run --protocol-file " + folder.path("p.toml") +
                " --device 'sim://healthy?seed=3' --db " + db + " --patient T-01 --fast");
  EXPECT_EQ(ended.status, 1) << ended.out;
  EXPECT_NE(ended.err.find("reading back trial 1"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("isograsp db rescue " + db), std::string::npos) << ended.err;
  EXPECT_EQ(ended.out.find("[completed]"), std::string::npos) << ended.out;
  std::vector<std::string> kept;
  for (const auto& entry : fs::directory_iterator(folder.path("state/isograsp/emergency")))
    if (entry.path().extension() == ".db") kept.push_back(entry.path());
  ASSERT_EQ(kept.size(), 1u);
  const auto store = storage::open_store(kept[0], storage::OpenMode::read_only).value();
  const auto trials = trials_in(*store);
  ASSERT_FALSE(trials.empty());
  EXPECT_EQ(trials[0].status, storage::TrialStatus::completed);
  EXPECT_GE(trials[0].samples, 2 * kSecond);
  EXPECT_EQ(static_cast<std::int64_t>(store->signals(trials[0]).value().rows()), trials[0].samples);
}

TEST(StatusZero, AClockBehindTheNewestSessionIsRefusedUnlessSomebodySaysThatItIsRight) {
  const TemporaryFolder folder;
  const std::string db = folder.path("clinic.db");
  {
    const auto store = storage::open_store(db, storage::OpenMode::create).value();
    storage::SessionRecord session;
    session.patient_id = store->add_patient("T-01").value().id;
    session.started_utc = "2199-01-01T00:00:00Z";
    const auto id = store->begin_session(session).value();
    ASSERT_TRUE(store->end_session(id, "2199-01-01T01:00:00Z").ok());
  }
  write_protocol(folder);
  const std::string run = "run --protocol-file " + folder.path("p.toml") +
                          " --device sim://healthy --db " + db + " --patient T-02 --fast";
  const auto refused = isograsp(run);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("2199-01-01T01:00:00Z"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("--clock-is-right"), std::string::npos) << refused.err;
  const auto store = storage::open_store(db, storage::OpenMode::read_only).value();
  EXPECT_EQ(store->patients().value().size(), 1u) << "nothing was written";
  const auto accepted = isograsp(run + " --clock-is-right");
  EXPECT_EQ(accepted.status, 0) << accepted.err;
}

}  // namespace
}  // namespace isograsp::app::status_zero_test
