// SPDX-License-Identifier: GPL-3.0-or-later
// Databases that were made to harm whoever opens them: refused in plain words, in little memory,
// and without waiting for anybody.
#include <functional>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include "storage/access/audit_head_file.hpp"
#include "storage/access/open_store.hpp"
#include "storage/crypto/secret.hpp"
#include "storage/file/database.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/planted_blocks.hpp"

namespace isograsp::storage::hostile_test {
namespace {

/// What `work` says in a process of its own that may have this much more memory than now.
std::string said_within(std::size_t more_MiB, const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    std::ifstream status("/proc/self/statm");
    std::size_t pages = 0;
    status >> pages;
    const rlim_t most = pages * 4096 + (more_MiB << 20);
    const rlimit limit{most, most};
    setrlimit(RLIMIT_AS, &limit);
    const std::string said = work();
    const bool done = write(ends[1], said.data(), said.size()) >= 0;
    _exit(done ? 0 : 1);
  }
  close(ends[1]);
  std::string said;
  std::array<char, 4096> bytes{};
  for (ssize_t count = 1; count > 0;) {
    count = read(ends[0], bytes.data(), bytes.size());
    if (count > 0) said.append(bytes.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return said;
}

constexpr std::size_t kLittle_MiB = 256;

struct HostileDatabase : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  RowId session_id = 0;

  void SetUp() override {
    const auto store = opened(path);
    session_id = must(store->begin_session(example_session(must(store->add_patient("P-1")).id)));
    TrialRecord trial = example_trial(session_id, 1);
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
  }
  void execute(const std::string& statement) const {
    soci::session sql(soci::sqlite3, path);
    sql << statement;
  }
  [[nodiscard]] std::string refusal() const {
    return said_within(kLittle_MiB, [this] {
      const auto store = open_store(path, OpenMode::read_only);
      if (!store) return store.error().message();
      const auto trials = (*store)->trials(session_id);
      if (!trials) return trials.error().message();
      const auto signals = (*store)->signals(trials->front());
      return signals ? "read" : signals.error().message();
    });
  }
};

TEST_F(HostileDatabase, AMegabyteDoesNotBecomeGigabytes) {
  constexpr std::size_t kRows = std::size_t{1} << 23;  // 64 MiB in each of 80 blocks: 5 GiB
  test::plant_blocks(path, 1, {80, kRows, 1, 1});
  execute("UPDATE trials SET sample_count = " + std::to_string(80 * kRows));
  EXPECT_LT(std::filesystem::file_size(path), 2'000'000u);
  EXPECT_NE(refusal().find("more than any trial"), std::string::npos) << refusal();
}

TEST_F(HostileDatabase, AFewRowsInHugeBlocksOfManyGroupsAreRefused) {
  constexpr std::size_t kRows = std::size_t{1} << 23;
  test::plant_blocks(path, 1, {1, kRows, 1, 80});
  execute("UPDATE trials SET sample_count = 10");
  EXPECT_NE(refusal().find("the block is longer than any trial"), std::string::npos) << refusal();
}

TEST_F(HostileDatabase, ThousandsOfColumnsReserveNoMemoryForRowsThatAreNotThere) {
  test::plant_blocks(path, 1, {0, 1, 10'000, 1});
  execute("UPDATE trials SET sample_count = 10000");
  EXPECT_NE(refusal().find("the block is missing"), std::string::npos) << refusal();
  execute("UPDATE signal_groups SET column_names = ''");
  EXPECT_NE(refusal(), "read");
}

TEST_F(HostileDatabase, NegativeCountsAreRefused) {
  test::plant_blocks(path, 1, {3, 100, 2, 1});
  for (const char* change :
       {"UPDATE signal_blocks SET row_count = -5", "UPDATE trials SET sample_count = -5"}) {
    try {
      execute(change);
    } catch (const soci::soci_error&) {
      continue;  // the table itself refuses it
    }
    EXPECT_NE(refusal(), "read") << change;
  }
}

TEST_F(HostileDatabase, AViewOrAComputedColumnIsRefusedBeforeItIsRead) {
  const std::string sound = bytes_of(path);
  for (const std::vector<std::string>& attack :
       {std::vector<std::string>{
            "ALTER TABLE events RENAME TO old_events",
            "CREATE VIEW events AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) "
            "SELECT i AS id, 1 AS session_id, 1 AS trial_id, 0.0 AS session_time_s, 'x' AS kind, "
            "hex(zeroblob(1000000)) AS text FROM n"},
        std::vector<std::string>{"ALTER TABLE events ADD COLUMN more TEXT GENERATED ALWAYS AS "
                                 "(hex(zeroblob(100000000))) VIRTUAL"}}) {
    std::ofstream(path, std::ios::binary) << sound;
    for (const auto& statement : attack) execute(statement);
    for (const OpenMode how : {OpenMode::existing, OpenMode::read_only}) {
      const auto store = open_store(path, how);
      ASSERT_FALSE(store.ok());
      EXPECT_NE(store.error().message().find("views or computed columns"), std::string::npos)
          << store.error().message();
    }
  }
}

TEST_F(HostileDatabase, AValueIsNoLargerThanTheLargestBlock) {
  auto database = must(Database::open(path, OpenMode::read_only));
  const auto asked = database.guard("asking"_text, [&] {
    std::string text;
    database.sql() << "SELECT hex(zeroblob(100000000))", soci::into(text);
  });
  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().message().find("too big"), std::string::npos) << asked.error().message();
}

/// Had anything waited for the pipe's other end, this test would never end.
TEST_F(HostileDatabase, APipeBesideTheFileOrInItsPlaceStopsNobody) {
  for (const char* suffix : {"-wal", "-shm", "-journal", "-lock", "-audit"}) {
    const std::string name = path + suffix;
    std::filesystem::remove(name);
    ASSERT_EQ(mkfifo(name.c_str(), 0600), 0);
    for (const OpenMode how : {OpenMode::existing, OpenMode::read_only, OpenMode::create}) {
      const auto store = open_store(path, how);
      ASSERT_FALSE(store.ok()) << suffix;
      EXPECT_NE(store.error().message().find(suffix), std::string::npos);
      EXPECT_NE(store.error().message().find("is not a plain file"), std::string::npos);
    }
    std::filesystem::remove(name);
  }
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(open_store(pipe, OpenMode::read_only).ok());
  const auto secret = Secret::from_file(pipe);
  ASSERT_FALSE(secret.ok());
  EXPECT_NE(secret.error().message().find("is not a file"), std::string::npos);
}

TEST_F(HostileDatabase, WhatStandsBesideADatabaseIsForThoseWhoMayUseTheDatabase) {
  const auto mode_of = [](const std::string& file) {
    return static_cast<int>(std::filesystem::status(file).permissions());
  };
  const mode_t before = umask(0077);
  for (const int mode : {0600, 0660}) {
    for (const char* suffix : {"-lock", "-audit", "-wal", "-shm"})
      std::filesystem::remove(path + suffix);
    std::filesystem::permissions(path, std::filesystem::perms{static_cast<unsigned>(mode)});
    const auto store = opened(path, OpenMode::existing);
    must(store->begin_trial(example_trial(session_id, 2 + mode)));
    write_head_file(path, nullptr, "id", {});
    for (const char* suffix : {"-lock", "-audit", "-wal", "-shm"})
      EXPECT_EQ(mode_of(path + suffix), mode) << suffix;
  }
  umask(before);
}

}  // namespace
}  // namespace isograsp::storage::hostile_test
