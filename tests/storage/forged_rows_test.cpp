// SPDX-License-Identifier: GPL-3.0-or-later
// What another program has forged never gets a seal by anything that this one does afterwards.
#include <algorithm>
#include <filesystem>

#include "storage/access/protection.hpp"
#include "storage/care/backups.hpp"
#include "storage/care/merge.hpp"
#include "storage/care/migration.hpp"
#include "storage/file/database.hpp"
#include "storage/sqlite/block_codec.hpp"
#include "tests/storage/clinic_under_attack.hpp"

namespace isograsp::storage::forged_rows_test {
namespace {

namespace fs = std::filesystem;

/// SQL: blocks of a second with the values of the packs of a trial, as any program can make them.
std::vector<std::string> packs_as_blocks(const std::string& path, RowId trial) {
  const auto store = opened(path, OpenMode::read_only);
  std::vector<std::string> statements;
  const TrialRecord forged = must(store->trials(1)).at(static_cast<std::size_t>(trial - 1));
  const auto rows = example_rows(forged, 100, 2);  // not what was measured
  for (std::size_t g = 0; g < forged.groups.size(); ++g) {
    const std::string bytes = encode_block(rows[g], forged.groups[g].columns.size());
    std::string hex;
    for (const char byte : bytes) {
      constexpr const char* kDigits = "0123456789abcdef";
      hex += kDigits[static_cast<unsigned char>(byte) >> 4U];
      hex += kDigits[static_cast<unsigned char>(byte) & 15U];
    }
    statements.push_back("INSERT INTO signal_blocks VALUES (" + std::to_string(trial) + ", " +
                         std::to_string(g) + ", 0, 100, " + std::to_string(crc32(bytes)) + ", x'" +
                         hex + "')");
  }
  return statements;
}

struct Forged : ClinicUnderAttack {
  /// The same again, and by a reader.
  void expect(const Problems& expected) const {
    for (const int time : {1, 2}) EXPECT_EQ(problems(), expected) << time;
    Problems read;
    for (const Text& one : must(opened(path, OpenMode::read_only)->check()))
      read.push_back(english(one));
    EXPECT_EQ(read, expected);
  }
};
INSTANTIATE_TEST_SUITE_P(Kinds, Forged, testing::Bool(), [](const auto& kind) {
  return std::string(kind.param ? "Protected" : "Unprotected");
});

const std::string kMadeRunning =
    "UPDATE trials SET status = 'running', sample_count = NULL, helped = 1 WHERE id = 2";
const std::string kBlocksOfPacked =
    "signal_blocks: trial 2 is packed, its rows here were not written by isograsp";
const std::string kTrialIsNot = "trials: row 2 is not what isograsp wrote";

TEST_P(Forged, ATrialMadeRunningIsNotMarkedAsInterruptedAndSealed) {
  auto statements = packs_as_blocks(path, 2);
  statements.push_back(kMadeRunning);
  attack(statements);
  expect({kBlocksOfPacked, kTrialIsNot});
  EXPECT_EQ(must(opened(path)->trials(1)).at(1).status, TrialStatus::running);
}

TEST_P(Forged, PacksTurnedIntoBlocksAreNotPackedAndSealed) {
  auto statements = packs_as_blocks(path, 2);
  statements.push_back(kMadeRunning);
  statements.push_back("UPDATE trials SET signals_blake2b = NULL WHERE id = 2");
  statements.push_back("DELETE FROM signal_packs WHERE trial_id = 2");
  attack(statements);
  expect({"signal_packs: row 2,0,0 is missing", "signal_packs: row 2,1,0 is missing", kTrialIsNot});
}

TEST_P(Forged, ABlockBesideThePacksIsNamed) {
  attack(packs_as_blocks(path, 2));
  expect({kBlocksOfPacked});
}

TEST_P(Forged, AnInterruptedTrialIsMarkedPackedAndProves) {
  {
    const auto store = opened(path, OpenMode::existing);
    TrialRecord trial = example_trial(1, 3);
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  }
  expect({});
  EXPECT_EQ(must(opened(path)->trials(1)).at(2).status, TrialStatus::interrupted);
}

/// Every way in which the program changes a part of a row that is there.
TEST_P(Forged, ARowThatTheProgramChangesLaterStaysWithoutASeal) {
  {
    const auto store = opened(path, OpenMode::existing);
    RatingRecord rating;
    rating.session_id = 1;
    rating.trial_id = 1;
    rating.recorded_utc = "2026-03-05T09:40:00Z";
    must(store->add_rating(rating));
    SessionRecord session = example_session(1);
    must(store->begin_session(session, {}));
  }
  attack({"UPDATE trials SET practice = 1 - practice WHERE id = 1",
          "UPDATE sessions SET operator_name = 'Mallory' WHERE id = 2",
          "UPDATE ratings SET session_time_s = 7.5 WHERE id = 1"});
  const Problems forged{"ratings: row 1 is not what isograsp wrote",
                        "sessions: row 2 is not what isograsp wrote",
                        "trials: row 1 is not what isograsp wrote"};
  expect(forged);
  {
    const auto store = opened(path, OpenMode::existing);
    must(store->mark_helped(1, true));
    must(store->mark_helped(2, true));
    must(store->end_session(2));
    RatingRecord rating = must(store->ratings(1)).at(0);
    rating.effort = 9;
    must(store->correct_rating(rating));
  }
  expect(forged);
}

/// SQLite gives the number of the last row of a table anew when that is gone.
TEST_P(Forged, ARowThatWasDeletedIsNamedThoughItsNumberIsGivenAnew) {
  std::vector<std::string> statements{"DELETE FROM trials WHERE id = 2"};
  for (const char* table : {"signal_packs", "signal_groups", "trial_references", "measures"})
    statements.push_back("DELETE FROM " + std::string(table) + " WHERE trial_id = 2");
  attack(statements);
  {
    const auto store = opened(path, OpenMode::existing);
    TrialRecord trial = example_trial(1, 2);
    trial.id = must(store->begin_trial(trial));
    ASSERT_EQ(trial.id, 2);
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 3)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, std::vector<Measure>{{"rmse", "force", 0.5, "N", 1, 100, 0, ""}}));
    EXPECT_EQ(must(store->signals(must(store->trials(1)).at(1))).rows(), 100u) << "is kept";
    trial = example_trial(1, 3);
    trial.id = must(store->begin_trial(trial));
    must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 4)));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
  }
  expect({"measures: row 2 is not what isograsp wrote", "signal_packs: row 2,0,0 is missing",
          "signal_packs: row 2,1,0 is missing", kTrialIsNot});
}

TEST_P(Forged, ARowThatIsRemovedHereAndMadeAnewProves) {
  for (int time = 0; time < 3; ++time) {
    const auto store = opened(path, OpenMode::existing);
    const RowId mark = must(store->add_treatment_mark(1, {0, "2026-02-01", "drug", "a mark"}));
    EXPECT_EQ(mark, 1) << "the same number";
    must(store->remove_treatment_mark(mark));
    must(store->add_treatment_mark(1, {0, "2026-02-02", "drug", "another"}));
    EXPECT_FALSE(store->add_treatment_mark(1, {0, "2026-02-30", "drug", "no date"}).ok());
    must(store->remove_treatment_mark(1));
  }
  expect({});
}

TEST_P(Forged, APersonWhoIsTakenBackAndAnotherOneInTheirPlaceProve) {
  for (int time = 0; time < 3; ++time) {
    const auto store = opened(path, OpenMode::existing);
    const auto mistaken = must(store->add_patient("P-8"));
    must(store->remove_patient(mistaken.id));
    const auto meant = must(store->add_patient("P-9"));
    EXPECT_EQ(meant.id, mistaken.id) << "the same number";
    const auto refused = store->remove_patient(1);
    ASSERT_FALSE(refused.ok()) << "there are sessions";
    EXPECT_NE(refused.error().message().find("something is stored"), std::string::npos);
    must(store->remove_patient(meant.id));
    EXPECT_FALSE(store->remove_patient(meant.id).ok()) << "is gone";
  }
  expect({});
}

TEST_P(Forged, MergingTakesInNoForgery) {
  const std::string other = folder.file("other.db");
  record(other, "P-2");
  if (GetParam()) {  // never merged
    EXPECT_FALSE(merge_databases(other, path).ok());
    return;
  }
  auto statements = packs_as_blocks(path, 2);
  statements.push_back(kMadeRunning);
  attack(statements);
  for (const auto& [into, from] : {std::pair{path, other}, {other, path}}) {
    const auto done = merge_databases(into, from);
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().file, path);
    EXPECT_NE(done.error().message().find("was changed by another program: " + kTrialIsNot +
                                          "; run isograsp db check"),
              std::string::npos)
        << done.error().message();
  }
  expect({kBlocksOfPacked, kTrialIsNot});
}

TEST_P(Forged, NeitherMigratingNorProtectingGivesNewSeals) {
  attack({"UPDATE measures SET value = 0.5 WHERE id = 1"});
  const auto migrated = migrate_database(path);
  ASSERT_FALSE(migrated.ok());
  const std::string named =
      "was changed by another program: measures: row 1 is not what isograsp wrote; run isograsp "
      "db check";
  EXPECT_NE(refusal(migrated).find(named), std::string::npos) << refusal(migrated);
  if (!GetParam()) {
    const auto done = protect_database(path, secret("the clinic's passphrase"), &kCheapKeyCost);
    ASSERT_FALSE(done.ok());
    EXPECT_NE(refusal(done).find(named), std::string::npos) << refusal(done);
    EXPECT_FALSE(is_protected_database(path));
  }
  expect({"measures: row 1 is not what isograsp wrote"});
}

TEST_P(Forged, AnAlteredLogIsNoMoreMigratedOrMerged) {
  attack({"DROP TRIGGER audit_log_is_not_changed",
          "UPDATE audit_log SET object = 'P-9' WHERE id = 2",
          "CREATE TRIGGER audit_log_is_not_changed BEFORE UPDATE ON audit_log BEGIN SELECT "
          "RAISE(ABORT, 'the audit log is only added to'); END"});
  EXPECT_NE(refusal(migrate_database(path)).find("audit log: entry 2"), std::string::npos);
  if (GetParam()) return;
  const std::string other = folder.file("other.db");
  record(other, "P-2");
  EXPECT_NE(refusal(merge_databases(other, path)).find("audit log: entry 2"), std::string::npos);
}

/// Children of a session stand in tables with and without numbers of rows.
TEST_P(Forged, RowsWhoseTrialWasDeletedAreNamedAndTheCheckGoesOn) {
  attack({"DELETE FROM trials WHERE id = 2"});
  const Problems all = problems();
  for (const char* one : {"row 2 of measures refers to a row of trials that does not exist",
                          "a row of trial_references refers to a row of trials that does not exist",
                          "trials: row 2 is missing"})
    EXPECT_NE(std::find(all.begin(), all.end(), one), all.end()) << one;
}

TEST_P(Forged, OfManyForgedRowsOfATableSomeAreNamedTheOthersCountedAndOtherTablesNamedToo) {
  attack(
      {"WITH RECURSIVE n (i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1500) INSERT "
       "INTO events (session_id, session_time_s, kind, text) SELECT 1, i, 'note', '' FROM n",
       "UPDATE trials SET helped = 1 WHERE id = 2"});
  const Problems all = problems();
  ASSERT_EQ(all.size(), 102u);
  EXPECT_EQ(all[0], "events: row 1 was not written by isograsp");
  EXPECT_EQ(all[100], kTrialIsNot);
  EXPECT_EQ(all[101], "events: 1400 more of its rows are not sound");
}

/// A copy that cannot be put back is no reason to remove one that can.
TEST_P(Forged, ABackupOfAnAlteredFileIsRefusedAndNoOlderOneRemoved) {
  const Backups backups(path, {1, 0, 0});
  constexpr std::time_t kMonday = 1'800'000'000;
  constexpr std::time_t kDay_s = 86400;
  const std::string monday = must(backups.make(kMonday)).backup.path;
  attack({"UPDATE measures SET value = 0.5 WHERE id = 1"});
  const auto tuesday = backups.make(kMonday + kDay_s);
  EXPECT_NE(
      refusal(tuesday).find("the copy is not sound: measures: row 1 is not what isograsp wrote"),
      std::string::npos)
      << refusal(tuesday);
  EXPECT_FALSE(opened(path)->backup(folder.file("copy.db")).ok());
  EXPECT_FALSE(fs::exists(folder.file("copy.db")));
  const auto kept = must(backups.list());
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].path, monday);
  const LogIn as_clinic = [](const std::string& copy) -> Result<std::unique_ptr<Access>> {
    auto mine = Access::open(copy);
    if (mine && (*mine)->is_protected())
      must((*mine)->log_in_with_passphrase(secret("the clinic's passphrase")));
    return mine;
  };
  access.reset();
  must(restore_backup(monday, path, as_clinic));
  log_in();
  expect({});
}

}  // namespace
}  // namespace isograsp::storage::forged_rows_test
