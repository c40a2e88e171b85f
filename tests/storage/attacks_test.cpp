// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody has the file of a protected database, an SQL program and no password, or an account that
// was taken away: nobody becomes more than they are.
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <thread>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/care/backups.hpp"
#include "storage/file/schema.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::attacks_test {
namespace {

namespace fs = std::filesystem;

struct Attacked : ProtectedClinic {
  Attacked() {
    as("Theo");
    must(set_own_pin(*access, secret("2580")));
    must(opened(path)->add_patient("P-1"));
  }
  void execute(const std::vector<std::string>& statements) const {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    for (const std::string& statement : statements) sql << statement;
  }
  [[nodiscard]] std::string copy(const std::string& name) const {
    must(opened(path, OpenMode::existing)->save_copy(folder.file(name)));
    return folder.file(name);
  }
};

TEST_F(Attacked, ARoleThatWasEditedIsNotReachedByThePin) {
  as("Ada");
  execute({"UPDATE users SET role = 'administrator' WHERE name = 'Theo'"});
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))).find("another name or role"),
            std::string::npos);
  EXPECT_EQ(access->user()->name, "Ada");
}

TEST_F(Attacked, AnotherNameIsNotReachedByThePinEither) {
  as("Ada");
  execute({"UPDATE users SET name = 'Theodor' WHERE name = 'Theo'"});
  EXPECT_NE(refusal(access->switch_user("Theodor", secret("2580"))), "");
}

TEST_F(Attacked, WrongPinsAreCountedInMemoryThoughTheFileIsPutBack) {
  for (int i = 0; i < kMostWrongPins; ++i) {
    EXPECT_NE(refusal(access->switch_user("Theo", secret("1111"))), "");
    execute({"UPDATE users SET pin_failed_count = 0"});
  }
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))).find("cannot be used now"),
            std::string::npos);
  as("Theo");
  must(access->switch_user("Theo", secret("2580")));
}

TEST_F(Attacked, WithoutItsKeySlotsItDoesNotBecomeADatabaseWithoutProtection) {
  access.reset();
  const std::string sound = folder.file("sound.db");
  fs::copy_file(path, sound);
  const std::vector<std::string> traces{"DELETE FROM key_slots", "DELETE FROM users",
                                        "DROP TRIGGER row_seals_are_not_cut",
                                        "DELETE FROM row_seals"};
  for (std::size_t count = 1; count <= traces.size(); ++count) {
    for (const char* suffix : {"-wal", "-shm"}) fs::remove(path + suffix);
    fs::copy_file(sound, path, fs::copy_options::overwrite_existing);
    execute({"PRAGMA foreign_keys=OFF"});
    execute({traces.begin(), traces.begin() + static_cast<std::ptrdiff_t>(count)});
    EXPECT_FALSE(Access::open(path).ok()) << count;
    EXPECT_FALSE(open_store(path, OpenMode::existing).ok()) << count;
    EXPECT_FALSE(open_store(path, OpenMode::read_only).ok()) << count;
  }
  EXPECT_NE(refusal(Access::open(path)).find("-audit"), std::string::npos)
      << "the last trace stands beside the file";
}

TEST_F(Attacked, ARevokedAccountThatIsPutBackOpensNothing) {
  const std::string before = copy("before.db");
  as("Ada");
  must(remove_user(*access, "Theo"));
  access.reset();
  execute({"ATTACH DATABASE '" + before + "' AS old", "PRAGMA foreign_keys=OFF",
           "DELETE FROM users", "DELETE FROM key_slots",
           "INSERT INTO users SELECT * FROM old.users",
           "INSERT INTO key_slots SELECT * FROM old.key_slots"});
  access = must(Access::open(path));
  EXPECT_NE(refusal(access->log_in("Theo", secret("theo's password"))).find("key_slots: row"),
            std::string::npos);
  EXPECT_FALSE(access->user());
}

/// While the window is open, under somebody else's login.
TEST_F(Attacked, NeitherARevokedAccountNorAnOldPinThatIsPutBackIsReachedByThePin) {
  const std::string before = copy("before.db");
  const std::vector<std::string> put_back{"ATTACH DATABASE '" + before + "' AS old",
                                          "PRAGMA foreign_keys=OFF", "DELETE FROM users",
                                          "INSERT INTO users SELECT * FROM old.users"};
  must(set_own_pin(*access, secret("3691")));
  as("Ada");
  execute(put_back);
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))).find("users: row 2 is not"),
            std::string::npos);
  EXPECT_EQ(access->user()->name, "Ada");
  EXPECT_NE(refusal(access->switch_user("Theo", secret("3691"))), "");
}

TEST_F(Attacked, ARevokedAccountThatIsPutBackIsNotReachedByItsPin) {
  const std::string before = copy("before.db");
  as("Ada");
  must(remove_user(*access, "Theo"));
  execute({"ATTACH DATABASE '" + before + "' AS old", "PRAGMA foreign_keys=OFF",
           "DELETE FROM users", "DELETE FROM key_slots",
           "INSERT INTO users SELECT * FROM old.users",
           "INSERT INTO key_slots SELECT * FROM old.key_slots"});
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))).find("key_slots: row"),
            std::string::npos);
  EXPECT_EQ(access->user()->name, "Ada");
}

/// Who has the right one is told what is wrong with the file, however often they try.
TEST_F(Attacked, ARightPasswordIsNeverCountedAsAWrongOneWhereSealsDoNotProve) {
  access.reset();
  execute({"UPDATE users SET created_utc = '1999-01-01T00:00:00Z' WHERE name = 'Rita'"});
  access = must(Access::open(path, [this] { return now_s; }));
  for (int time = 0; time < 6; ++time)
    EXPECT_NE(refusal(access->log_in_with_passphrase(secret("the clinic's passphrase")))
                  .find("users: row 3 is not what isograsp wrote"),
              std::string::npos)
        << time;
}

TEST_F(Attacked, AnOldPassphraseThatIsPutBackOpensNothing) {
  const std::string before = copy("before.db");
  as("Ada");
  must(change_passphrase(*access, secret("another passphrase"), kCheapKeyCost));
  access.reset();
  execute({"ATTACH DATABASE '" + before + "' AS old",
           "DELETE FROM key_slots WHERE kind = 'passphrase'",
           "INSERT INTO key_slots SELECT * FROM old.key_slots WHERE kind = 'passphrase'"});
  access = must(Access::open(path));
  EXPECT_NE(refusal(access->log_in_with_passphrase(secret("the clinic's passphrase"))), "");
  EXPECT_FALSE(access->user());
}

TEST_F(Attacked, WrongPasswordsThatAreTriedAtOnceAreCountedOneByOne) {
  access.reset();
  constexpr int kAtOnce = 8;
  constexpr int kFree = 3;  // the third begins to wait
  std::atomic<int> tried = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < kAtOnce; ++i)
    threads.emplace_back([&] {
      const auto mine = must(Access::open(path, [this] { return now_s; }));
      const auto said = refusal(mine->log_in("Theo", secret("a wrong password")));
      if (said.find("too many") == std::string::npos) ++tried;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(tried, kFree);
}

TEST_F(Attacked, AnOlderFileThatIsPutBackIsSaidAtLogin) {
  EXPECT_TRUE(access->notices().empty());
  const std::string before = copy("before.db");
  must(opened(path)->add_patient("P-2"));
  access.reset();
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(path + suffix);
  fs::copy_file(before, path);
  access = must(Access::open(path));
  as("Theo");
  ASSERT_EQ(access->notices().size(), 1u);
  EXPECT_NE(english(access->notices()[0]).find("older"), std::string::npos);
}

const std::vector<std::string> kLogNotCut{
    "CREATE TRIGGER audit_log_is_not_cut BEFORE DELETE ON audit_log BEGIN SELECT RAISE(ABORT, 'the "
    "audit log is only added to'); END"};

/// Without the key nobody makes an anchor for what is left; the next entry and the next seal, which
/// have it, make none either.
TEST_F(Attacked, AnEndThatWasCutOffStaysNamedWhateverIsWrittenLater) {
  const auto expect = [this](const std::string& wanted) {
    for (const char* code : {"P-8", "P-9"}) {
      const auto store = opened(path, OpenMode::existing);
      must(store->add_patient(code));
      const auto found = must(store->check());
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const Text& one) {
        return english(one) == wanted;
      })) << wanted;
      must(store->set_profile(must(store->find_patient(code))->id, {}));
    }
  };
  execute({"DROP TRIGGER audit_log_is_not_cut", "DELETE FROM audit_log WHERE id > 3",
           "UPDATE audit_anchor SET count = 3, hash = (SELECT hash FROM audit_log WHERE id = 3)"});
  execute(kLogNotCut);
  fs::remove(path + "-audit");
  expect("audit log: its anchor was changed");
  execute({"DROP TRIGGER row_seals_are_not_cut", "DELETE FROM patients WHERE code = 'P-1'",
           "DELETE FROM row_seals WHERE id >= (SELECT min(id) FROM row_seals WHERE of_table = "
           "'patients')",
           "UPDATE row_seals_anchor SET count = (SELECT max(id) FROM row_seals), chain = (SELECT "
           "chain FROM row_seals ORDER BY id DESC LIMIT 1)",
           "CREATE TRIGGER row_seals_are_not_cut BEFORE DELETE ON row_seals BEGIN SELECT "
           "RAISE(ABORT, 'seals are only added'); END"});
  execute({"DELETE FROM patient_profiles", "DELETE FROM patients"});
  expect("row_seals_anchor: row 1 was changed");
}

TEST_F(Attacked, ALogThatWasRemovedIsNotBegunAnew) {
  access.reset();
  execute(
      {"DROP TRIGGER audit_log_is_not_cut", "DELETE FROM audit_log", "DELETE FROM audit_anchor"});
  execute(kLogNotCut);
  fs::remove(path + "-audit");
  access = must(Access::open(path));
  as("Theo");
  const auto problems = must(opened(path, OpenMode::existing)->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(english(problems[0]), "audit log: its anchor was changed");
}

TEST_F(Attacked, ARemovedAuditHeadIsSaidAtTheNextLogin) {
  access.reset();
  fs::remove(path + "-audit");
  access = must(Access::open(path));
  as("Theo");
  ASSERT_EQ(access->notices().size(), 1u);
  EXPECT_NE(english(access->notices()[0]).find("there is no file -audit"), std::string::npos);
  as("Theo");
  EXPECT_TRUE(access->notices().empty()) << "it is made anew";
}

/// It would run with whoever writes, and travel with every backup.
TEST_F(Attacked, AForeignTriggerIsNamedSealsNothingAndIsInNoBackup) {
  execute(
      {"CREATE TRIGGER theirs AFTER INSERT ON patients BEGIN UPDATE patients SET created_utc = "
       "'1999-01-01T00:00:00Z' WHERE id = 1; END"});
  const auto store = opened(path, OpenMode::existing);
  must(store->add_patient("P-2"));
  const auto problems = must(store->check());
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(english(problems[0]), "sqlite_schema: theirs was not made by isograsp");
  EXPECT_EQ(english(problems[1]), "patients: row 1 is not what isograsp wrote");
  EXPECT_FALSE(store->backup(folder.file("monday.db")).ok());
  EXPECT_FALSE(Backups(path).make(std::time(nullptr)).ok());
}

/// The name of a table that emergency files have.
TEST_F(Attacked, AForeignTriggerIsNamedWhateverItsName) {
  execute(
      {"CREATE TRIGGER emergency_origin AFTER INSERT ON patients BEGIN UPDATE patients SET "
       "created_utc = '1999-01-01T00:00:00Z' WHERE id = 1; END"});
  const auto problems = must(opened(path, OpenMode::existing)->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(english(problems[0]), "sqlite_schema: emergency_origin was not made by isograsp");
}

/// SQLite reads the statements and takes the names beside them as they are, in letters of any size.
TEST_F(Attacked, AnyWordOfTheSchemaThatIsChangedIsNamed) {
  const std::string good = folder.file("good.db");
  must(opened(path, OpenMode::existing)->save_copy(good));
  test::AtLeast tried(200);
  for (const char* column : {"name", "tbl_name", "type", "sql"}) {
    int rows = 0;
    soci::session(soci::sqlite3, "db=\"" + good + "\"")
        << "SELECT count(*) FROM sqlite_schema WHERE " + std::string(column) + " <> ''",
        soci::into(rows);
    for (int row = 0; row < rows; ++row) {
      const std::string bad = folder.file("bad.db");
      fs::copy_file(good, bad, fs::copy_options::overwrite_existing);
      const std::string changed = column;
      {
        soci::session sql(soci::sqlite3, "db=\"" + bad + "\"");
        sql << "PRAGMA writable_schema=ON";
        sql << "UPDATE sqlite_schema SET " + changed + " = upper(substr(" + changed +
                   ", 1, 4)) || lower(substr(" + changed +
                   ", 5)) WHERE rowid = (SELECT rowid FROM " + "sqlite_schema WHERE " + changed +
                   " <> '' ORDER BY rowid LIMIT 1 OFFSET " + std::to_string(row) + ")";
      }
      const auto store = open_store(bad, OpenMode::read_only);
      const auto problems = store ? (*store)->check() : Result<std::vector<Text>>(store.error());
      // Some of them SQLite does not open.
      EXPECT_TRUE(!problems || !problems->empty()) << column << ", row " << row;
      ++tried;
    }
  }
}

/// Of the rows that the program writes in the same transaction, too; and after the trigger is gone.
TEST_F(Attacked, ARowThatATriggerChangesGetsNoSealThoughTheProgramWritesItToo) {
  const std::string mine = "created_utc = '1999-01-01T00:00:00Z' WHERE id = NEW.id; END";
  execute({"CREATE TRIGGER one AFTER INSERT ON patients BEGIN UPDATE patients SET " + mine,
           "CREATE TRIGGER two AFTER UPDATE OF affected ON patient_profiles BEGIN UPDATE "
           "patient_profiles SET notes = '' WHERE patient_id = NEW.patient_id; END",
           "CREATE TRIGGER three BEFORE UPDATE OF dominant ON patient_profiles BEGIN DELETE FROM "
           "treatment_marks; END"});
  {
    const auto store = opened(path, OpenMode::existing);
    must(store->add_patient("P-2"));
    must(store->set_profile(1, {Side::left, Hand::right, "", "a note", "a goal"}));
    must(store->add_treatment_mark(1, {0, "2026-02-01", "drug", "a mark"}));
    must(store->set_profile(1, {Side::right, Hand::right, "", "a note", "a goal"}));
  }
  execute({"DROP TRIGGER one", "DROP TRIGGER two", "DROP TRIGGER three"});
  const std::vector<std::string> expected{"patient_profiles: row 1 is not what isograsp wrote",
                                          "patients: row 2 was not written by isograsp",
                                          "treatment_marks: row 1 is missing"};
  for (const bool changed_again : {false, true}) {
    const auto store = opened(path, OpenMode::existing);
    if (changed_again) must(store->set_profile(1, {Side::none, {}, "", "a note", "a goal"}));
    std::vector<std::string> found;
    for (const Text& one : must(store->check())) found.push_back(english(one));
    EXPECT_EQ(found, expected);
  }
}

TEST_F(Attacked, AForeignTableAndAMissingIndexAreNamed) {
  execute({"CREATE TABLE theirs (id INTEGER)", "DROP INDEX events_of_session"});
  const auto problems = must(opened(path, OpenMode::existing)->check());
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_NE(english(problems[0]).find("theirs"), std::string::npos);
  EXPECT_NE(english(problems[1]).find("CREATE INDEX events_of_session"), std::string::npos);
}

/// What it says is compared with nothing.
TEST_F(Attacked, ATableOfEmergencyFilesIsNamedInAClinicsFileWhateverItSays) {
  for (const char* made : {schema::kEmergencyOrigin, "CREATE TABLE emergency_origin (a)"}) {
    execute({made});
    for (const bool has_row : {false, true}) {
      if (has_row)
        execute({"INSERT INTO emergency_origin VALUES (" +
                 std::string(made == schema::kEmergencyOrigin ? "'/a', 'b', 'c'" : "1") + ")"});
      const auto problems = must(opened(path, OpenMode::existing)->check());
      ASSERT_EQ(problems.size(), 1u);
      EXPECT_EQ(english(problems[0]), "sqlite_schema: emergency_origin was not made by isograsp");
    }
    execute({"DROP TABLE emergency_origin"});
  }
}

TEST_F(Attacked, AViewIsNotOpenedAtAll) {
  execute({"CREATE VIEW theirs AS SELECT 1"});
  EXPECT_FALSE(open_store(path, OpenMode::existing).ok());
}

}  // namespace
}  // namespace isograsp::storage::attacks_test
