// SPDX-License-Identifier: GPL-3.0-or-later
// The chain of the audit log: complete, and every change, move and cut noticed.
#include "storage/access/audit_log.hpp"

#include <atomic>
#include <thread>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/care/backups.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::audit_log_test {
namespace {

namespace fs = std::filesystem;

/// What somebody with an SQL program does to the file, triggers out of the way.
void attack(const std::string& path, const std::vector<std::string>& statements) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  for (const char* trigger :
       {"audit_log_is_not_changed", "audit_log_is_not_cut", "audit_log_is_not_replaced"})
    sql << "DROP TRIGGER IF EXISTS " + std::string(trigger);
  for (const auto& statement : statements) sql << statement;
}

std::vector<std::string> acts_of(Access& access) {
  std::vector<std::string> acts;
  for (const auto& entry : must(read_audit(access)))
    acts.push_back(entry.act + " " + entry.object + " " + entry.result + " by " + entry.actor);
  return acts;
}

struct Audit : ProtectedClinic {
  Audit() {
    as("Theo");
    {
      const auto store = opened(path);
      const RowId patient = must(store->add_patient("P-1")).id;
      const RowId session = must(store->begin_session(example_session(patient)));
      must(store->end_session(session));
    }
    must(set_identity(*access, "P-1", {"Vera", "", ""}));
    as("Ada");
  }
  [[nodiscard]] std::vector<Text> problems() { return must(check_audit(*access)); }
};

TEST_F(Audit, EveryBackupIsInItWhoeverMakesIt) {
  must(Backups(path).make(std::time(nullptr)));
  as("Rita");
  must(must(open_store_to_read(path))->backup(folder.file("ritas.db")));
  access->lock();
  must(Backups(path).make(std::time(nullptr) + 86400));
  as("Ada");
  const auto backups = must(read_audit(*access, {"backup", ""}));
  ASSERT_EQ(backups.size(), 3u);
  EXPECT_EQ(backups[2].actor + " " + backups[2].result, "Rita done") << "behind the lock";
  EXPECT_EQ(backups[1].actor + " " + backups[1].object, "Rita ritas.db");
  EXPECT_TRUE(problems().empty());
}

TEST_F(Audit, TellsWhoDidWhatToWhatWithWhichResult) {
  as("Rita");
  EXPECT_FALSE(read_identity(*access, "P-1").ok());
  EXPECT_FALSE(access->log_in("Theo", secret("not his password")).ok());
  EXPECT_FALSE(access->log_in("my secret typed as a name", secret("anything")).ok());
  as("Theo");
  EXPECT_FALSE(opened(path)->add_patient("P-1").ok());
  EXPECT_FALSE(opened(path)->add_patient("Vera Novak").ok());
  must(read_identity(*access, "P-1"));
  must(opened(path)->backup(folder.file("monday.db")));
  as("Ada");
  const auto acts = acts_of(*access);
  const std::vector<std::string> expected{"login clinic passphrase done by clinic passphrase",
                                          "create clinic.db done by clinic passphrase",
                                          "new recovery key  done by clinic passphrase",
                                          "add user Ada done by clinic passphrase",
                                          "add user Theo done by clinic passphrase",
                                          "add user Rita done by clinic passphrase",
                                          "login Theo done by Theo",
                                          "add patient P-1 done by Theo",
                                          "begin session P-1 done by Theo",
                                          "end session P-1 done by Theo",
                                          "change identity P-1 done by Theo",
                                          "login Ada done by Ada",
                                          "login Rita done by Rita",
                                          "read identity P-1 refused by Rita",
                                          "login Theo refused by ",
                                          "login unknown user refused by ",
                                          "login Theo done by Theo",
                                          "add patient P-1 refused by Theo",
                                          "read identity P-1 done by Theo",
                                          "backup monday.db done by Theo",
                                          "login Ada done by Ada"};
  EXPECT_EQ(acts, expected);
  EXPECT_TRUE(problems().empty());
  for (const auto& entry : test::every(must(read_audit(*access))))
    for (const std::string& text : {entry.object, entry.detail})
      for (const char* told : {"Vera", "Novak", "typed", "password"})
        EXPECT_TRUE(text.find(told) == std::string::npos || text == "wrong password") << text;
}

TEST_F(Audit, IsReadByAdministratorsOnly) {
  as("Theo");
  EXPECT_FALSE(read_audit(*access).ok());
  as("Rita");
  EXPECT_FALSE(read_audit(*access).ok());
}

TEST_F(Audit, IsNotChangedCutOrReplacedThroughSql) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  for (const char* statement :
       {"UPDATE audit_log SET actor = 'nobody' WHERE id = 3", "DELETE FROM audit_log WHERE id = 3",
        "DELETE FROM audit_log",
        "INSERT OR REPLACE INTO audit_log SELECT id, at_utc, 'nobody', role, act, object, result, "
        "detail, hash, seals FROM audit_log WHERE id = 3"})
    EXPECT_THROW(sql << statement, soci::soci_error) << statement;
  EXPECT_TRUE(problems().empty());
}

TEST_F(Audit, NoticesAChangeOfAnyFieldOfAnyEntry) {
  const auto count = must(audit_head(*access)).count;
  const std::string good = folder.file("good.db");
  must(opened(path)->backup(good));
  for (std::int64_t id = 1; id <= count; ++id)
    for (const char* field : {"at_utc", "actor", "role", "act", "object", "detail"}) {
      const std::string bad = folder.file("bad.db");
      fs::copy_file(good, bad, fs::copy_options::overwrite_existing);
      attack(bad, {"UPDATE audit_log SET " + std::string(field) + " = " + field +
                   " || 'x' WHERE id = " + std::to_string(id)});
      const auto found = must(check_audit(*must(Access::open(bad))));
      ASSERT_EQ(found.size(), 1u) << field << " of " << id;
      EXPECT_NE(english(found[0]).find("entry " + std::to_string(id) + " "), std::string::npos)
          << english(found[0]);
    }
}

TEST_F(Audit, NoticesAnotherOrderAMissingAndAnInventedEntry) {
  attack(path,
         {"UPDATE audit_log SET id = 100 WHERE id = 3", "UPDATE audit_log SET id = 3 WHERE id = 4",
          "UPDATE audit_log SET id = 4 WHERE id = 100"});
  EXPECT_FALSE(problems().empty());
}

TEST_F(Audit, NoticesAMissingEntry) {
  attack(path, {"DELETE FROM audit_log WHERE id = 3"});
  ASSERT_FALSE(problems().empty());
  EXPECT_NE(english(problems()[0]).find("entries 3 to 3 are missing"), std::string::npos)
      << english(problems()[0]);
}

TEST_F(Audit, NoticesAnInventedEntry) {
  attack(path, {"INSERT INTO audit_log SELECT id + 1, at_utc, actor, role, act, 'P-2', result, "
                "detail, hash, seals FROM audit_log ORDER BY id DESC LIMIT 1"});
  EXPECT_FALSE(problems().empty());
}

TEST_F(Audit, NoticesACutEvenIfTheAnchorIsCutToo) {
  attack(path, {"DELETE FROM audit_log WHERE id > 5"});
  EXPECT_FALSE(problems().empty());
  attack(path,
         {"UPDATE audit_anchor SET count = 5, hash = (SELECT hash FROM audit_log WHERE id = 5)"});
  EXPECT_FALSE(problems().empty()) << "the proof of the anchor was not asked for";
  // What is done after a cut does not heal it.
  must(opened(path)->add_patient("P-2"));
  EXPECT_FALSE(problems().empty());
}

TEST_F(Audit, NoticesAFilePutBackToAnEarlierState) {
  const std::string earlier = folder.file("earlier.db");
  must(opened(path)->backup(earlier));
  must(opened(path)->add_patient("P-2"));
  EXPECT_TRUE(problems().empty());
  const AuditHead noted = must(audit_head(*access));
  access.reset();
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(path + suffix);
  fs::copy_file(earlier, path);
  access = must(Access::open(path));
  as("Ada");
  ASSERT_FALSE(problems().empty());
  EXPECT_NE(english(problems()[0]).find("was put back or cut"), std::string::npos)
      << english(problems()[0]);
  EXPECT_FALSE(must(audit_contains(*access, noted))) << "a head on paper proves it too";
  const auto count = must(audit_head(*access)).count;
  while (must(audit_head(*access)).count < noted.count + 5)
    must(log_act(*access, "report", "", true));
  EXPECT_GT(must(audit_head(*access)).count, count);
  EXPECT_FALSE(problems().empty()) << "forgotten once the log is as long as it was";
}

TEST_F(Audit, ARestoredFileGoesOnFromItsBackupAndKeepsTheEvidence) {
  const std::string backup = must(Backups(path).make(std::time(nullptr))).backup.path;
  const std::string before = bytes_of(backup);
  fs::create_directory(folder.file("links"));
  const std::string link = folder.file("links/clinic.db");
  fs::create_symlink(path, link);
  for (const char* number : {"", "-2"}) {
    must(opened(path)->add_patient(std::string("P-9") + (*number == '\0' ? "1" : "2")));
    const std::string head = bytes_of(path + "-audit");
    access.reset();
    const auto restored = must(restore_backup(backup, link, [this](const std::string& copy) {
      auto opened = Access::open(copy);
      if (opened) must((*opened)->log_in("Theo", secret("theo's password")));
      return opened;
    }));
    EXPECT_EQ(restored.kept, path + ".before-restore" + number);
    EXPECT_EQ(bytes_of(path + "-audit.old" + number), head) << "the head of the file that was kept";
    access = must(Access::open(path));
    as("Ada");
    EXPECT_TRUE(problems().empty());
    const auto entry = must(read_audit(*access, {"restore", ""})).at(0);
    EXPECT_EQ(entry.actor, "Theo");
    EXPECT_EQ(entry.detail, fs::path(backup).filename().string() +
                                "; as it was: clinic.db.before-restore" + number);
  }
  EXPECT_EQ(bytes_of(backup), before) << "asked for the login";
  for (const std::string& name : test::every(folder.listing()))
    EXPECT_EQ(name.find(".restored"), std::string::npos) << "nothing half made: " << name;
}

TEST_F(Audit, AResearcherRestoresNothing) {
  const std::string backup = must(Backups(path).make(std::time(nullptr))).backup.path;
  as("Rita");
  EXPECT_NE(refusal(restore_backup(backup, folder.file("other.db"))).find("researcher"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder.file("other.db")));
  EXPECT_FALSE(fs::exists(path + ".before-restore"));
}

TEST_F(Audit, ANewDatabaseOfTheSameNameBeginsItsOwn) {
  access.reset();
  for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(path + suffix);
  const std::string head = bytes_of(path + "-audit");
  access = must(Access::create(path, secret("the clinic's passphrase"), &kCheapKeyCost)).access;
  EXPECT_TRUE(problems().empty());
  EXPECT_EQ(bytes_of(path + "-audit.old"), head);
}

TEST_F(Audit, IsCheckedWhileOthersAddToIt) {
  std::atomic<bool> done = false;
  std::thread other([&] {
    const auto theirs = must(Access::open(path));
    for (int i = 0; i < 100; ++i) must(log_act(*theirs, "report", "P-1", true));
    done = true;
  });
  std::vector<Text> found;
  while (!done && found.empty()) found = problems();
  other.join();
  EXPECT_EQ(found, std::vector<Text>{});
}

TEST_F(Audit, AnotherKeyCannotMakeTheChain) {
  // An attacker who knows the hash, but not the key, writes a whole chain of their own.
  access.reset();
  const std::string other = folder.file("other.db");
  auto theirs = must(Access::create(other, secret("their passphrase"), &kCheapKeyCost)).access;
  theirs.reset();
  attack(path, {"DELETE FROM audit_log", "DELETE FROM audit_anchor",
                "ATTACH DATABASE '" + other + "' AS other",
                "INSERT INTO audit_log SELECT * FROM other.audit_log",
                "INSERT INTO audit_anchor SELECT * FROM other.audit_anchor"});
  access = must(Access::open(path));
  as("Ada");
  EXPECT_FALSE(problems().empty());
}

TEST_F(Audit, CheckOfTheStoreProvesTheChain) {
  EXPECT_TRUE(must(opened(path)->check()).empty());
  attack(path, {"UPDATE audit_log SET actor = 'x' WHERE id = 2"});
  const auto found = must(opened(path)->check());
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NE(english(found[i]).find("CREATE TRIGGER audit_log_is_not_"), std::string::npos)
        << "the triggers that had to go: " << english(found[i]);
  EXPECT_NE(english(found[3]).find("entry 2"), std::string::npos);
}

TEST(UnprotectedAudit, IsChainedToo) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  must(store->set_profile(patient, {Side::left, {}, "", "", ""}));
  const auto access = must(Access::open(path));
  must(add_consent(*access, "P-1", {0, "2026-03-05", "research", "consent", "given", "", "", ""}));
  EXPECT_EQ(acts_of(*access),
            (std::vector<std::string>{"add patient P-1 done by ", "change profile P-1 done by ",
                                      "add consent P-1 done by "}));
  EXPECT_TRUE(must(store->check()).empty());
  attack(path, {"DELETE FROM audit_log WHERE id = 3"});
  EXPECT_FALSE(must(store->check()).empty());
}

TEST(UnprotectedAudit, AnActAndItsEntryAreStoredTogether) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto store = opened(path);
  attack(path, {"CREATE TRIGGER full BEFORE INSERT ON audit_log BEGIN SELECT RAISE(ABORT, 'full'); "
                "END"});
  EXPECT_FALSE(store->add_patient("P-1").ok());
  EXPECT_TRUE(must(store->patients()).empty()) << "done, but not logged";
}

}  // namespace
}  // namespace isograsp::storage::audit_log_test
