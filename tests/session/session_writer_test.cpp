// SPDX-License-Identifier: GPL-3.0-or-later
// A trial counts as stored when another connection has read it back as it was. Here something gets
// at the file in between, and that must be found out.
#include "session/session_writer.hpp"

#include <cstdlib>
#include <functional>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/care/emergency.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/variable.hpp"

namespace isograsp::session::session_writer_test {
namespace {

namespace fs = std::filesystem;

/// Happens once, when this process opens its next connection: that is the one that reads back.
class AtNextOpening {
 public:
  explicit AtNextOpening(std::function<void()> act) {
    what() = std::move(act);
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(&strike));
  }
  ~AtNextOpening() {
    sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&strike));
    what() = {};
  }
  AtNextOpening(const AtNextOpening&) = delete;
  AtNextOpening& operator=(const AtNextOpening&) = delete;
  [[nodiscard]] static bool has_happened() { return !what(); }

 private:
  static std::function<void()>& what() {
    static std::function<void()> act;
    return act;
  }
  static int strike(sqlite3*, char**, const sqlite3_api_routines*) {
    if (const auto act = std::exchange(what(), {})) act();
    return SQLITE_OK;
  }
};

/// By a program of its own.
std::function<void(const std::string&)> sql(const std::string& statements) {
  return [statements](const std::string& path) {
    EXPECT_EQ(std::system(("sqlite3 '" + path + "' \"" + statements + "\"").c_str()), 0);
  };
}

void overwrite_log(const std::string& path) {
  constexpr std::streamoff kLogHeader = 32;
  std::fstream log(path + "-wal", std::ios::in | std::ios::out | std::ios::binary);
  const auto bytes = static_cast<std::size_t>(fs::file_size(path + "-wal")) - kLogHeader;
  log.seekp(kLogHeader);
  log << std::string(bytes, 'x');
}

struct Interference {
  const char* name;
  std::function<void(const std::string& path)> strike;
  const char* words;
};

constexpr const char* kOtherSamples =
    "UPDATE signal_packs AS p SET (float64_shuffled_zstd, values_blake2b) = (SELECT "
    "o.float64_shuffled_zstd, o.values_blake2b FROM signal_packs o WHERE o.trial_id = 1 AND "
    "o.position = p.position AND o.part = p.part) WHERE trial_id = 2; "
    "UPDATE trials SET signals_blake2b = (SELECT signals_blake2b FROM trials WHERE id = 1) "
    "WHERE id = 2;";

const Interference kInterferences[]{
    {"samples are damaged",
     sql("UPDATE signal_packs SET float64_shuffled_zstd = "
         "zeroblob(length(float64_shuffled_zstd)) WHERE trial_id = 2;"),
     "trial 2"},
    {"sound samples of another trial stand there, with their hashes", sql(kOtherSamples),
     "its signals are not those that were stored"},
    {"a measure is changed",
     sql("UPDATE measures SET value = value + 1e-12 WHERE trial_id = 2 AND name = 'rmse';"),
     "its measures are not those that were stored"},
    {"a measure is gone", sql("DELETE FROM measures WHERE trial_id = 2 AND name = 'rmse';"),
     "its measures are not those that were stored"},
    {"its end is taken back", sql("UPDATE trials SET status = 'interrupted' WHERE id = 2;"),
     "it is there as 'interrupted'"},
    {"it is gone",
     sql("DELETE FROM measures WHERE trial_id = 2; DELETE FROM signal_packs WHERE trial_id = 2; "
         "DELETE FROM signal_groups WHERE trial_id = 2; DELETE FROM trial_references WHERE "
         "trial_id = 2; DELETE FROM trials WHERE id = 2;"),
     "it is not there"},
    {"the log is overwritten", overwrite_log, "trial 2"}};

/// A session with one completed trial, and a second one that is under way.
class Recording {
 public:
  Recording() {
    auto store = storage::opened(path);
    const storage::PatientRecord patient = storage::must(store->add_patient("P-1"));
    storage::SessionRecord session = storage::example_session(patient.id);
    session.uuid = "5a7c1d1e-0000-4000-8000-000000000001";
    session.id = storage::must(store->begin_session(session));
    writer.emplace(std::move(store), patient, session, std::vector<storage::SessionAnswer>(), true);
    begin(1);
    EXPECT_TRUE(end());
    begin(2);
  }
  Result<void> end() {
    trial.status = storage::TrialStatus::completed;
    trial.samples = 200;
    Measure measure;
    measure.name = "rmse";
    measure.channel = "force";
    measure.value = 0.1 * trial.number;
    measure.unit = "N";
    measure.samples = 200;
    return writer->end_trial(trial, {measure});
  }
  /// As it was recorded, to the bit.
  void expect_second_trial_in(const std::string& file, const std::string& name) const {
    const auto store = storage::opened(file, storage::OpenMode::read_only);
    const auto trials =
        storage::must(store->trials(storage::must(store->recent_sessions(1)).at(0).id));
    ASSERT_EQ(trials.size(), 2u) << name;
    EXPECT_EQ(trials[1].status, storage::TrialStatus::completed) << name;
    const auto measures = storage::must(store->measures(trials[1].id));
    ASSERT_EQ(measures.size(), 1u) << name;
    EXPECT_EQ(measures[0].value, 0.2) << name;
    const Signals signals = storage::must(store->signals(trials[1]));
    ASSERT_EQ(signals.rows(), 200u) << name;
    for (std::size_t row = 0; row < 200; ++row)
      for (std::size_t column = 0; column < 3; ++column)
        ASSERT_TRUE(storage::same_bits(signals.column(column)[row],
                                       seconds_[row / 100][0][3 * (row % 100) + column]))
            << name;
  }

 private:
  void begin(int number) {
    trial = storage::example_trial(0, number);
    storage::must(writer->begin_trial(trial, trial.id));
    seconds_.clear();
    for (int second = 0; second < 2; ++second) {
      seconds_.push_back(
          storage::example_rows(trial, 100, static_cast<unsigned>(10 * number + second)));
      storage::must(writer->append_blocks(trial.id, second, seconds_.back()));
    }
  }

  storage::TemporaryFolder folder_;
  test::Variable state_{"XDG_STATE_HOME", folder_.file("state")};

 public:
  std::string path = folder_.file("clinic.db");
  std::optional<SessionWriter> writer;
  storage::TrialRecord trial;

 private:
  std::vector<SecondOfSignals> seconds_;
};

TEST(ReadingBack, FindsWhateverGotAtATrialInBetweenAndTheTrialIsNotStoredButKept) {
  for (const Interference& one : kInterferences) {
    Recording recording;
    Result<void> ended;
    {
      const AtNextOpening between([&] { one.strike(recording.path); });
      ended = recording.end();
      ASSERT_TRUE(between.has_happened());
    }
    ASSERT_FALSE(ended) << one.name;
    const std::string said = ended.error().message();
    EXPECT_EQ(ended.error().code, Error::Code::failed) << one.name;
    EXPECT_NE(said.find("reading back trial 2"), std::string::npos) << one.name << ": " << said;
    EXPECT_NE(said.find(one.words), std::string::npos) << one.name << ": " << said;
    const auto kept = storage::emergency_files();
    ASSERT_EQ(kept.size(), 1u) << one.name << ": " << said;
    EXPECT_NE(said.find(kept[0].path), std::string::npos) << said;
    recording.expect_second_trial_in(kept[0].path, one.name);
  }
}

TEST(ReadingBack, WhatWasChangedInBetweenComesBackFromTheEmergencyFile) {
  for (const Interference& one : kInterferences) {
    if (one.strike.target<decltype(&overwrite_log)>() != nullptr) continue;  // a backup's affair
    Recording recording;
    {
      const AtNextOpening between([&] { one.strike(recording.path); });
      ASSERT_FALSE(recording.end()) << one.name;
    }
    storage::must(recording.writer->end_session("2026-03-01T10:00:00Z"));
    recording.writer.reset();
    const auto files = storage::emergency_files(recording.path);
    ASSERT_EQ(files.size(), 1u) << one.name;
    const auto done = storage::rescue(recording.path, files[0]);
    ASSERT_TRUE(done) << one.name << ": " << done.error().message();
    EXPECT_TRUE(done->conflicts.empty()) << one.name << ": " << english(done->conflicts.front());
    recording.expect_second_trial_in(recording.path, one.name);
    EXPECT_TRUE(storage::must(storage::opened(recording.path)->check()).empty()) << one.name;
    EXPECT_TRUE(storage::emergency_files().empty()) << one.name;
  }
}

TEST(ReadingBack, AtTheEndOfTheSessionEveryTrialIsLookedAtOnceMore) {
  Recording recording;
  storage::must(recording.end());
  {
    const AtNextOpening later([&] { sql(kOtherSamples)(recording.path); });
    const auto ended = recording.writer->end_session("2026-03-01T10:00:00Z");
    ASSERT_FALSE(ended);
    EXPECT_NE(ended.error().message().find("its signals are not those that were stored"),
              std::string::npos)
        << ended.error().message();
  }
  ASSERT_EQ(storage::emergency_files().size(), 1u);
  recording.expect_second_trial_in(storage::emergency_files()[0].path, "at the end");
}

}  // namespace
}  // namespace isograsp::session::session_writer_test
