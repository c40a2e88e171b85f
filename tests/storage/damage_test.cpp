// SPDX-License-Identifier: GPL-3.0-or-later
// A damaged file is noticed, the place is named, and the rest can still be read.
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "tests/storage/examples.hpp"

namespace isograsp {
namespace {

struct Damage : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  RowId session_id = 0;

  void SetUp() override {
    const auto store = open_store(path);
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
};

TEST_F(Damage, ABitFlipInABlockIsNamedAndOtherTrialsCanBeRead) {
  std::string block;
  {
    soci::session sql(soci::sqlite3, path);
    soci::blob data(sql);
    sql << "SELECT float64_shuffled_zstd FROM signal_blocks b JOIN trials t ON t.id = b.trial_id "
           "WHERE t.number = 2 AND position = 1 AND second = 1",
        soci::into(data);
    block.resize(data.get_len());
    data.read(0, block.data(), block.size());
  }
  std::string bytes = bytes_of(path);
  // Same seed, same blocks: trial 1 holds the same bytes, trial 2 comes last.
  const auto at = bytes.rfind(block);
  ASSERT_NE(at, std::string::npos) << "the block lies within one page";
  bytes[at + block.size() / 2] = static_cast<char>(bytes[at + block.size() / 2] ^ 0x10);
  std::ofstream(path, std::ios::binary) << bytes;

  const auto store = open_store(path, SessionStore::Open::existing);
  const auto trials = must(store->trials(session_id));
  EXPECT_TRUE(store->signals(trials[0]).ok());
  const auto broken = store->signals(trials[1]);
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().message().find(
                "trial 2 of session 1, group raw, second 1: the block is damaged (checksum)"),
            std::string::npos)
      << broken.error().message();
  const auto problems = must(store->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("trial 2"), std::string::npos) << problems[0];
}

TEST_F(Damage, AMissingBlockIsNamed) {
  execute("DELETE FROM signal_blocks WHERE trial_id = 1 AND position = 0 AND second = 1");
  const auto store = open_store(path, SessionStore::Open::existing);
  const auto broken = store->signals(must(store->trials(session_id))[0]);
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().message().find("group force, second 1: the block is missing"),
            std::string::npos);
}

TEST_F(Damage, AMissingLastBlockIsNamed) {
  execute("DELETE FROM signal_blocks WHERE trial_id = 1 AND position = 1 AND second = 2");
  const auto store = open_store(path, SessionStore::Open::existing);
  const auto broken = store->signals(must(store->trials(session_id))[0]);
  ASSERT_FALSE(broken.ok());
  EXPECT_NE(broken.error().message().find("group raw, second 2: the block is missing"),
            std::string::npos);
}

TEST_F(Damage, AnOrphanRowIsFoundByTheCheck) {
  execute("DELETE FROM patients");
  const auto problems = must(open_store(path, SessionStore::Open::existing)->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("row 1 of sessions refers to a row of patients"), std::string::npos);
}

TEST_F(Damage, ATornFileIsAnErrorNotACrash) {
  const std::string bytes = bytes_of(path);
  std::ofstream(path, std::ios::binary) << bytes.substr(0, 3 * bytes.size() / 5);
  const auto store = SessionStore::open(path, SessionStore::Open::read_only);
  if (store) {
    const auto problems = (*store)->check();
    EXPECT_TRUE(!problems.ok() || !problems->empty());
  }
}

TEST_F(Damage, BackupIsASoundCopyMadeWhileAnotherWrites) {
  const auto store = open_store(path, SessionStore::Open::existing);
  TrialRecord trial = example_trial(session_id, 3);
  trial.id = must(store->begin_trial(trial));
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 9)));
  const std::string to = folder.file("copy of 'clinic'.db");
  must(open_store(path, SessionStore::Open::read_only)->backup(to));
  must(store->append_blocks(trial.id, 1, example_rows(trial, 100, 9)));

  const auto copy = open_store(to, SessionStore::Open::read_only);
  EXPECT_EQ(must(copy->check()), std::vector<std::string>{});
  const auto trials = must(copy->trials(session_id));
  ASSERT_EQ(trials.size(), 3u);
  EXPECT_EQ(trials[2].samples, 100);
  EXPECT_TRUE(same_bits(must(copy->signals(trials[0])).column(1)[7],
                        must(store->signals(must(store->trials(session_id))[0])).column(1)[7]));
}

TEST_F(Damage, BackupOverwritesNothingAndLeavesNothingHalfMade) {
  const auto store = open_store(path, SessionStore::Open::existing);
  EXPECT_FALSE(store->backup(path).ok());
  EXPECT_FALSE(store->backup(folder.file("absent/copy.db")).ok());
  execute("DELETE FROM signal_blocks WHERE trial_id = 1 AND position = 1 AND second = 2");
  EXPECT_FALSE(store->backup(folder.file("copy.db")).ok()) << "the source is damaged";
  for (const auto& name : folder.listing()) EXPECT_EQ(name.rfind("clinic.db", 0), 0u) << name;
}

}  // namespace
}  // namespace isograsp
