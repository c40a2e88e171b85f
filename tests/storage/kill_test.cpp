// SPDX-License-Identifier: GPL-3.0-or-later
// What was confirmed survives kill -9 and a full disk.
#include <chrono>
#include <thread>

#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/writer_process.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::kill_test {
namespace {

/// Every confirmed second and event is there, nothing is half there, the values are right.
void expect_recovered(SessionStore& store, const std::string& said, TrialStatus status) {
  const auto patient = must(store.find_patient("P-1"));
  ASSERT_TRUE(patient);
  const auto sessions = must(store.sessions(patient->id));
  const auto& session = *std::max_element(sessions.begin(), sessions.end(),
                                          [](const auto& a, const auto& b) { return a.id < b.id; });
  const auto trials = must(store.trials(session.id));
  ASSERT_EQ(trials.size(), 1u);
  const auto& trial = trials[0];
  EXPECT_EQ(trial.status, status);
  const int confirmed = count_lines(said, "second ");
  EXPECT_EQ(trial.samples % 100, 0) << "whole seconds only";
  EXPECT_GE(trial.samples, 100 * confirmed);
  EXPECT_LE(trial.samples, 100 * (confirmed + 1)) << "at most one was not yet confirmed";
  EXPECT_GE(static_cast<int>(must(store.events(session.id)).size()), count_lines(said, "event "));
  const Signals signals = must(store.signals(trial));
  ASSERT_EQ(signals.names().size(), 60u);
  bool right = true;
  for (std::size_t c = 0; c < 60; ++c)
    for (std::size_t r = 0; r < signals.rows(); ++r)
      right = right && signals.column(c)[r] == static_cast<double>(r * 30 + c % 30);
  EXPECT_TRUE(right);
  EXPECT_EQ(must(store.check()), std::vector<Text>{});
}

/// scripts/test --long sets it.
int kills() {
  return std::getenv("ISOGRASP_LONG") != nullptr ? 100 : 5;
}

TEST(Kill, WhileTrialsAreClosedAndPackedLosesNone) {
  constexpr unsigned kLongestLife_ms = 300;
  constexpr int kSeconds = 3;  // so that most of the time a trial is being closed
  std::mt19937_64 random(20260303);
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  for (int run = 0; run < kills(); ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    WriterProcess writer(path, std::to_string(kSeconds), 0, "100000");
    ASSERT_TRUE(writer.wait_for("closed 1"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % (1000 * kLongestLife_ms)));
    const int closed = count_lines(writer.kill_and_read(), "closed ");
    const auto store = opened(path, OpenMode::existing);
    const auto sessions = must(store->sessions(must(store->find_patient("P-1"))->id));
    const auto& session = *std::max_element(
        sessions.begin(), sessions.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    const auto trials = must(store->trials(session.id));
    ASSERT_GE(static_cast<int>(trials.size()), closed);
    for (int i = 0; i < closed; ++i) {
      const auto& trial = trials[static_cast<std::size_t>(i)];
      EXPECT_EQ(trial.status, TrialStatus::completed);
      EXPECT_EQ(must(store->signals(trial)).rows(), 100u * kSeconds);
      EXPECT_EQ(trial.signals_hash.size(), 64u);
    }
    for (const auto& trial : test::every(trials)) EXPECT_TRUE(store->signals(trial).ok());
  }
  EXPECT_EQ(must(opened(path)->check()), std::vector<Text>{});
}

TEST(Kill, WhatWasConfirmedIsThereAndTheTrialIsMarkedInterrupted) {
  constexpr unsigned kLongestLife_ms = 300;  // some hundred commits; a kill hits any place of them
  std::mt19937_64 random(20260301);
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  for (int run = 0; run < kills(); ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    WriterProcess writer(path);
    ASSERT_TRUE(writer.wait_for("second 0"));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % (1000 * kLongestLife_ms)));
    const std::string said = writer.kill_and_read();
    const auto store = opened(path, OpenMode::existing);
    expect_recovered(*store, said, TrialStatus::interrupted);
  }
}

TEST(Kill, DuringTheMakingOfTheFileLeavesAWholeFileOrNone) {
  constexpr int kRuns = 10;
  TemporaryFolder folder;
  for (int run = 0; run < kRuns; ++run) {
    const std::string path = folder.file("new" + std::to_string(run) + ".db");
    {
      WriterProcess writer(path);
      std::this_thread::sleep_for(std::chrono::milliseconds(run));
      writer.kill_and_read();
    }
    if (!std::filesystem::exists(path)) continue;
    EXPECT_EQ(must(opened(path, OpenMode::existing)->check()), std::vector<Text>{});
  }
}

TEST(FullDisk, IsAnErrorAndLosesNothingConfirmed) {
  constexpr rlim_t kLargestFile = 1 << 20;  // some ten seconds of signals
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  WriterProcess writer(path, "1000", kLargestFile);
  const std::string said = writer.end_and_read();
  EXPECT_EQ(writer.exit_status(), 3) << said;
  EXPECT_NE(said.find("the size that this program may write (RLIMIT_FSIZE), or the disk is full"),
            std::string::npos)
      << said;
  EXPECT_GT(count_lines(said, "second "), 3);
  const auto store = opened(path, OpenMode::existing);
  expect_recovered(*store, said, TrialStatus::interrupted);
}

TEST(FullDisk, WhileTheFileIsMadeLeavesNothingBehind) {
  TemporaryFolder folder;
  WriterProcess writer(folder.file("clinic.db"), "1", 8192);
  const std::string said = writer.end_and_read();
  EXPECT_EQ(writer.exit_status(), 3) << said;
  EXPECT_EQ(folder.listing(), std::vector<std::string>{});
}

}  // namespace
}  // namespace isograsp::storage::kill_test
