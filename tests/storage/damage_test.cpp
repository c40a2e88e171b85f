// SPDX-License-Identifier: GPL-3.0-or-later
// A damaged file is noticed, the place is named, and the rest can still be read.
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::damage_test {
namespace {

struct Damage : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  RowId session_id = 0;

  void SetUp() override {
    const auto store = opened(path);
    const auto patient = must(store->add_patient("P-1"));
    session_id = must(store->begin_session(example_session(patient.id)));
    for (int number = 1; number <= 2; ++number) {
      TrialRecord trial = example_trial(session_id, number);
      trial.id = must(store->begin_trial(trial));
      for (int s = 0; s < 3; ++s)
        must(store->append_blocks(trial.id, s, example_rows(trial, 100, static_cast<unsigned>(s))));
      trial.status = TrialStatus::completed;
      must(store->end_trial(trial, {}));
    }
  }

  void execute(const std::string& statement) const {
    soci::session sql(soci::sqlite3, path);
    sql << statement;
  }
  /// A BLOB of the file, as it stands in it.
  [[nodiscard]] std::string blob(const std::string& query) const {
    soci::session sql(soci::sqlite3, path);
    soci::blob data(sql);
    sql << query, soci::into(data);
    std::string bytes(data.get_len(), '\0');
    data.read(0, bytes.data(), bytes.size());
    return bytes;
  }
  /// The signals of trial `number`, with what the file says now.
  [[nodiscard]] Result<Signals> read(int number) const {
    const auto store = opened(path, OpenMode::existing);
    return store->signals(must(store->trials(session_id)).at(static_cast<std::size_t>(number - 1)));
  }
  void expect_named(int number, const std::string& what) const {
    const auto broken = read(number);
    ASSERT_FALSE(broken.ok());
    EXPECT_NE(broken.error().message().find(what), std::string::npos) << broken.error().message();
  }
  /// A trial whose program ended: its signals are in blocks of a second.
  void leave_running(int number) const {
    const auto store = opened(path, OpenMode::existing);
    TrialRecord trial = example_trial(session_id, number);
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 3; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, static_cast<unsigned>(s))));
  }
};

TEST_F(Damage, ABitFlipInABlockIsNamedAndOtherTrialsCanBeRead) {
  const std::string block = blob(
      "SELECT float64_shuffled_zstd FROM signal_packs b JOIN trials t ON t.id = b.trial_id "
      "WHERE t.number = 2 AND position = 1");
  std::string bytes = bytes_of(path);
  // Same seed, same blocks: trial 1 holds the same bytes, trial 2 comes last.
  const auto at = bytes.rfind(block);
  ASSERT_NE(at, std::string::npos) << "the block lies within one page";
  bytes[at + block.size() / 2] = static_cast<char>(bytes[at + block.size() / 2] ^ 0x10);
  std::ofstream(path, std::ios::binary) << bytes;
  EXPECT_TRUE(read(1).ok());
  expect_named(2, "trial 2 of session 1, group raw, seconds 0 to 9: the block is damaged");
  const auto problems = must(opened(path)->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(english(problems[0]).find("trial 2"), std::string::npos) << english(problems[0]);
}

TEST_F(Damage, NoBitFlipInStoredSignalsGivesOtherValues) {
  const Signals sound = must(read(2));
  const std::string whole = bytes_of(path);
  constexpr int kFlips = 200;
  std::mt19937_64 random(20260302);
  int noticed = 0;
  for (const std::string column : {"float64_shuffled_zstd", "values_blake2b"}) {
    const std::string block =
        blob("SELECT " + column + " FROM signal_packs WHERE trial_id = 2 AND position = 1");
    const auto at = whole.rfind(block);
    ASSERT_NE(at, std::string::npos);
    for (int flip = 0; flip < kFlips; ++flip) {
      std::string bytes = whole;
      const auto bit = random() % (8 * block.size());
      char& hit = bytes[at + bit / 8];
      hit = static_cast<char>(hit ^ (1 << (bit % 8)));
      std::ofstream(path, std::ios::binary) << bytes;
      const auto got = opened(path, OpenMode::read_only)->signals([&] {
        TrialRecord trial = example_trial(session_id, 2);
        trial.id = 2;
        trial.samples = 300;
        trial.status = TrialStatus::completed;
        return trial;
      }());
      if (!got) {
        ++noticed;
        continue;
      }
      // A few bits of a Zstandard header mean nothing.
      for (std::size_t c = 0; c < sound.names().size(); ++c)
        for (std::size_t r = 0; r < sound.rows(); ++r)
          ASSERT_TRUE(same_bits(got->column(c)[r], sound.column(c)[r])) << column << bit;
    }
  }
  EXPECT_GE(noticed, 2 * kFlips - kFlips / 20);
}

TEST_F(Damage, SignalsOfAnotherTrialAreNoticedThoughEachBlockIsSound) {
  {
    const auto store = opened(path);
    TrialRecord trial = example_trial(session_id, 3);
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 3; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, 9)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
  }
  execute("DELETE FROM signal_packs WHERE trial_id = 1 AND position = 1");
  execute("UPDATE signal_packs SET trial_id = 1 WHERE trial_id = 3 AND position = 1");
  expect_named(1, "trial 1 of session 1: the signals are not those that were recorded (content");
  EXPECT_TRUE(read(2).ok());
}

TEST_F(Damage, ARenamedColumnIsNoticed) {
  execute("UPDATE signal_groups SET column_names = 'index_fz_counts' WHERE position = 1");
  expect_named(1, "the signals are not those that were recorded");
}

TEST_F(Damage, AMissingBlockIsNamed) {
  execute("DELETE FROM signal_packs WHERE trial_id = 1 AND position = 0");
  expect_named(1, "group force, seconds 0 to 9: the block is missing");
}

TEST_F(Damage, AMissingSecondOfAnInterruptedTrialIsNamedAndTheRestStays) {
  leave_running(3);
  execute("DELETE FROM signal_blocks WHERE trial_id = 3 AND position = 1 AND second = 1");
  expect_named(3, "group raw, second 1: the block is missing");
  const auto store = opened(path);
  const auto events = must(store->events(session_id));
  ASSERT_EQ(events.size(), 1u) << "why it was not packed";
  EXPECT_EQ(events[0].kind, "storage");
  EXPECT_NE(events[0].text.find("second 1: the block is missing"), std::string::npos);
  EXPECT_EQ(must(store->trials(session_id))[2].status, TrialStatus::interrupted);
}

TEST_F(Damage, AMissingLastSecondAndABitFlipInASecondAreNamed) {
  leave_running(3);
  execute("DELETE FROM signal_blocks WHERE trial_id = 3 AND position = 1 AND second = 2");
  expect_named(3, "group raw, second 2: the block is missing");
  leave_running(4);
  execute("UPDATE signal_blocks SET crc32 = crc32 + 1 WHERE trial_id = 4 AND second = 0");
  expect_named(4, "group force, second 0: the block is damaged (checksum)");
}

TEST_F(Damage, TheBeginningOfADamagedTrialAndItsFirstGroupsCanBeRead) {
  TrialRecord trial = example_trial(session_id, 3);
  {
    const auto store = opened(path);
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 25; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, 3)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
    trial = must(store->trials(session_id)).at(2);
  }
  const Signals sound = must(read(3));
  execute(
      "UPDATE signal_packs SET values_blake2b = zeroblob(32) "
      "WHERE trial_id = 3 AND position = 1 AND part = 1");
  expect_named(3, "group raw, seconds 10 to 19: the block is damaged (content hash)");
  const auto store = opened(path);
  trial.samples = 950;
  const Signals beginning = must(store->signals(trial));
  ASSERT_EQ(beginning.rows(), 950u);
  for (std::size_t c = 0; c < sound.names().size(); ++c)
    for (std::size_t r = 0; r < beginning.rows(); ++r)
      ASSERT_TRUE(same_bits(beginning.column(c)[r], sound.column(c)[r]));
  trial.samples = 1001;
  EXPECT_FALSE(store->signals(trial).ok());
  trial.samples = 2500;
  trial.groups.pop_back();
  EXPECT_EQ(must(store->signals(trial)).rows(), 2500u);
}

TEST_F(Damage, AnOrphanRowIsFoundByTheCheck) {
  execute("DELETE FROM patients");
  const auto problems = must(opened(path, OpenMode::existing)->check());
  ASSERT_FALSE(problems.empty());
  EXPECT_NE(english(problems[0]).find("row 1 of sessions refers to a row of patients"),
            std::string::npos);
}

TEST_F(Damage, ATornFileIsAnErrorNotACrash) {
  const std::string bytes = bytes_of(path);
  std::ofstream(path, std::ios::binary) << bytes.substr(0, 3 * bytes.size() / 5);
  const auto called_sound = [&] {
    const auto store = open_store(path, OpenMode::read_only);
    if (!store) return false;
    const auto problems = (*store)->check();
    return problems.ok() && problems->empty();
  };
  EXPECT_FALSE(called_sound());
}

TEST_F(Damage, BackupIsASoundCopyMadeWhileAnotherWrites) {
  const auto store = opened(path, OpenMode::existing);
  TrialRecord trial = example_trial(session_id, 3);
  trial.id = must(store->begin_trial(trial));
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 9)));
  const std::string to = folder.file("copy of 'clinic'.db");
  must(opened(path, OpenMode::read_only)->backup(to));
  must(store->append_blocks(trial.id, 1, example_rows(trial, 100, 9)));

  const auto copy = opened(to, OpenMode::read_only);
  EXPECT_EQ(must(copy->check()), std::vector<Text>{});
  const auto trials = must(copy->trials(session_id));
  ASSERT_EQ(trials.size(), 3u);
  EXPECT_EQ(trials[2].samples, 100);
  EXPECT_TRUE(same_bits(must(copy->signals(trials[0])).column(1)[7],
                        must(store->signals(must(store->trials(session_id))[0])).column(1)[7]));
}

TEST_F(Damage, BackupOverwritesNothingAndLeavesNothingHalfMade) {
  const auto store = opened(path, OpenMode::existing);
  EXPECT_FALSE(store->backup(path).ok());
  EXPECT_FALSE(store->backup(folder.file("absent/copy.db")).ok());
  execute("DELETE FROM signal_packs WHERE trial_id = 1 AND position = 1");
  EXPECT_FALSE(store->backup(folder.file("copy.db")).ok()) << "the source is damaged";
  for (const auto& name : test::every(folder.listing()))
    EXPECT_EQ(name.rfind("clinic.db", 0), 0u) << name;
}

}  // namespace
}  // namespace isograsp::storage::damage_test
