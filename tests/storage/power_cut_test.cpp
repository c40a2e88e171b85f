// SPDX-License-Identifier: GPL-3.0-or-later
// The power is cut between any two writes: what was confirmed is there, nothing is half there. And
// the disk is full at any write.
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/power_cut_vfs.hpp"

namespace isograsp::storage::power_cut_test {
namespace {

constexpr int kRows = 100;
enum Counter : std::size_t { kTrials, kSeconds, kClosed };

std::vector<std::vector<double>> rows_of(const TrialRecord& trial, int second) {
  return example_rows(trial, kRows, static_cast<unsigned>(1000 * trial.number + second));
}

/// Records `trials` trials of `seconds` seconds and tells the layer what was confirmed.
void record(PowerCutVfs& disk, const std::string& path, OpenMode how, int trials, int seconds) {
  const auto store = opened(path, how);
  const RowId patient = must(store->add_patient("P-1")).id;
  const RowId session = must(store->begin_session(example_session(patient)));
  for (int number = 1; number <= trials; ++number) {
    TrialRecord trial = example_trial(session, number);
    trial.id = must(store->begin_trial(trial));
    disk.confirm(kSeconds, 0);
    disk.confirm(kTrials, number);
    for (int second = 0; second < seconds; ++second) {
      must(store->append_blocks(trial.id, second, rows_of(trial, second)));
      disk.confirm(kSeconds, second + 1);
    }
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
    disk.confirm(kClosed, number);
  }
}

/// What is wrong with the file after a cut; empty: nothing.
std::string fault_after(const PowerCutVfs::Cut& cut, int seconds) {
  const TemporaryFolder folder;
  cut.restore(folder.path());
  const auto confirmed = [&](Counter counter) {
    return counter < cut.confirmed.size() ? cut.confirmed[counter] : 0;
  };
  const auto opened = open_store(folder.file("clinic.db"), OpenMode::existing);
  if (!opened) return opened.error().message();
  SessionStore& store = **opened;
  const auto problems = store.check();
  if (!problems) return problems.error().message();
  if (!problems->empty()) return english(problems->front());
  const auto patient = must(store.find_patient("P-1"));
  if (!patient) return confirmed(kTrials) > 0 ? "the patient is lost" : "";
  const auto sessions = must(store.sessions(patient->id));
  if (sessions.empty()) return confirmed(kTrials) > 0 ? "the session is lost" : "";
  const auto trials = must(store.trials(sessions[0].id));
  const int there = static_cast<int>(trials.size());
  if (there < confirmed(kTrials) || there > confirmed(kTrials) + 1)
    return std::to_string(there) + " trials of " + std::to_string(confirmed(kTrials));
  for (const TrialRecord& trial : trials) {
    const bool last = trial.number == confirmed(kTrials);
    const int least = trial.number <= confirmed(kClosed) ? seconds : last ? confirmed(kSeconds) : 0;
    if (trial.number <= confirmed(kClosed) && trial.status != TrialStatus::completed)
      return "the end of a trial is lost";
    if (trial.samples % kRows != 0) return "a second is torn";
    const auto stored = static_cast<int>(trial.samples / kRows);
    if (stored < least || stored > least + 1)
      return std::to_string(stored) + " seconds of " + std::to_string(least);
    const auto signals = store.signals(trial);
    if (!signals) return signals.error().message();
    for (int second = 0; second < stored; ++second) {
      const auto rows = rows_of(trial, second);
      for (std::size_t i = 0; i < rows[0].size(); ++i)
        if (!same_bits(signals->column(i % 3)[static_cast<std::size_t>(second) * kRows + i / 3],
                       rows[0][i]))
          return "a value is another one";
    }
  }
  return "";
}

std::vector<std::string> faults(OpenMode how, unsigned seed, unsigned every, int trials,
                                int seconds, std::size_t& cuts) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  PowerCutVfs disk(folder.path(), seed);
  disk.cut_in_one_of(every);
  record(disk, path, how, trials, seconds);
  std::vector<std::string> all;
  cuts = disk.cuts().size();
  for (const auto& cut : disk.cuts())
    if (const auto fault = fault_after(cut, seconds); !fault.empty()) all.push_back(fault);
  return all;
}

TEST(PowerCut, AtAnyWriteLosesNothingThatWasConfirmed) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    std::size_t cuts = 0;
    // Longer than a packed block, long enough for checkpoints of the log.
    EXPECT_EQ(faults(OpenMode::existing, seed, 12, 4, 12, cuts), std::vector<std::string>{});
    EXPECT_GT(cuts, 20u);
  }
}

TEST(PowerCut, WithoutSyncsWouldBeFound) {
  // The layer itself is put to the test: a scratch file waits for no disk.
  std::size_t cuts = 0;
  EXPECT_FALSE(faults(OpenMode::scratch, 4, 10, 4, 12, cuts).empty());
  EXPECT_GT(cuts, 20u);
}

TEST(FullDisk, AtAnyWriteOfTheCloseLosesNoSecond) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  PowerCutVfs disk(folder.path(), 1);
  const auto store = opened(path, OpenMode::existing);
  const RowId session =
      must(store->begin_session(example_session(must(store->add_patient("P-1")).id)));
  constexpr int kSeconds = 12;
  int refused = 0;
  int not_packed = 0;
  bool through = false;
  for (int writes = 0; !through; ++writes) {
    TrialRecord trial = example_trial(session, writes + 1);
    trial.id = must(store->begin_trial(trial));
    for (int second = 0; second < kSeconds; ++second)
      must(store->append_blocks(trial.id, second, rows_of(trial, second)));
    trial.status = TrialStatus::completed;
    disk.full_after(writes);
    const auto ended = store->end_trial(trial, {});
    disk.full_after(-1);
    if (!ended) {
      ++refused;
      EXPECT_NE(ended.error().message().find("the disk is full"), std::string::npos);
      must(store->end_trial(trial, {}));  // once there is space
    }
    const auto stored = must(store->trials(session)).back();
    EXPECT_EQ(stored.status, TrialStatus::completed);
    if (stored.signals_hash.empty()) ++not_packed;
    const Signals signals = must(store->signals(stored));
    ASSERT_EQ(signals.rows(), static_cast<std::size_t>(kSeconds * kRows));
    EXPECT_TRUE(same_bits(signals.column(0)[kRows], rows_of(trial, 1)[0][0]));
    through = ended.ok() && !stored.signals_hash.empty();
    ASSERT_LT(writes, 500);
  }
  EXPECT_GT(refused, 0) << "full before the trial was closed";
  EXPECT_GT(not_packed, 0) << "full while it was packed";
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
}

}  // namespace
}  // namespace isograsp::storage::power_cut_test
