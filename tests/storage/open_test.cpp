// SPDX-License-Identifier: GPL-3.0-or-later
// Which files are opened, and that the others stay as they were.
#include <functional>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>
#include <sys/wait.h>

#include "storage/access/open_store.hpp"
#include "storage/file/database.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::open_test {
namespace {

/// Opening fails in all the given ways, the message says `why`, and the folder is as before.
void expect_refused(const TemporaryFolder& folder, const std::string& path,
                    std::initializer_list<OpenMode> ways, const std::string& why) {
  const auto file_bytes = [&path] {
    return std::filesystem::is_directory(path) ? std::string() : bytes_of(path);
  };
  const std::string before = file_bytes();
  const auto listing = folder.listing();
  for (const OpenMode how : test::every(ways)) {
    const auto store = open_store(path, how);
    ASSERT_FALSE(store.ok()) << static_cast<int>(how);
    const std::string message = store.error().message();
    EXPECT_NE(message.find(why), std::string::npos) << message;
    EXPECT_EQ(message.rfind(path, 0), 0u) << "starts with the file: " << message;
    EXPECT_NE(message.find("; "), std::string::npos) << "names a remedy: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line: " << message;
    EXPECT_EQ(file_bytes(), before);
    EXPECT_EQ(folder.listing(), listing);
  }
}

/// Runs `claim` as a user who owns nothing here; root may write anywhere.
bool as_nobody(const std::function<bool()>& claim) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    _exit(claim() ? 0 : 1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(OpenStore, MakesAWalDatabaseMarkedAsOurs) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic with space = sign.db");
  const auto store = opened(path);
  EXPECT_EQ(store->path(), path);
  EXPECT_EQ(must(store->patients()).size(), 0u);
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::string mode;
  int id = 0;
  int version = 0;
  sql << "PRAGMA journal_mode", soci::into(mode);
  sql << "PRAGMA application_id", soci::into(id);
  sql << "PRAGMA user_version", soci::into(version);
  EXPECT_EQ(mode, "wal");
  EXPECT_EQ(id, 0x49736F47);
  EXPECT_EQ(version, kDatabaseFormat);
}

TEST(OpenStore, CreateKeepsWhatIsThere) {
  TemporaryFolder folder;
  must(opened(folder.file("clinic.db"))->add_patient("P-1"));
  EXPECT_EQ(must(opened(folder.file("clinic.db"))->patients()).size(), 1u);
}

TEST(OpenStore, OnlyAScratchFileIsNotSyncedToTheDisk) {
  TemporaryFolder folder;
  for (const auto& [how, expected] : {std::pair{OpenMode::create, 2},
                                      {OpenMode::existing, 2},
                                      {OpenMode::read_only, 2},
                                      {OpenMode::scratch, 0}}) {
    auto database = must(Database::open(folder.file("clinic.db"), how));
    int synchronous = -1;
    database.sql() << "PRAGMA synchronous", soci::into(synchronous);
    EXPECT_EQ(synchronous, expected);
  }
  must(opened(folder.file("scratch.db"), OpenMode::scratch)->add_patient("P-1"));
  EXPECT_EQ(must(opened(folder.file("scratch.db"))->patients()).size(), 1u);
}

TEST(OpenStore, AbsentFileIsRefusedAndNotMade) {
  TemporaryFolder folder;
  expect_refused(folder, folder.file("absent.db"), {OpenMode::existing, OpenMode::read_only},
                 "does not exist");
  expect_refused(folder, folder.file("no/folder.db"), {OpenMode::create},
                 "its folder does not exist");
}

TEST(OpenStore, TextFileEmptyFileAndFolderAreRefused) {
  TemporaryFolder folder;
  const std::string text = folder.file("text.db");
  std::ofstream(text) << "t_s,thumb_fz_N\n0,1\n";
  expect_refused(folder, text, {OpenMode::create, OpenMode::existing, OpenMode::read_only},
                 "is not a database");
  const std::string empty = folder.file("empty.db");
  std::ofstream{empty};
  expect_refused(folder, empty, {OpenMode::create, OpenMode::existing, OpenMode::read_only},
                 "is not a database");
  expect_refused(folder, folder.path(), {OpenMode::create, OpenMode::existing, OpenMode::read_only},
                 "is a folder");
}

TEST(OpenStore, DatabaseOfAnotherProgramIsNeverTouched) {
  TemporaryFolder folder;
  for (const std::string mode : {"DELETE", "WAL"}) {
    const std::string path = folder.file("foreign-" + mode + ".db");
    {
      soci::session sql(soci::sqlite3, path);
      std::string answer;
      sql << "PRAGMA journal_mode=" + mode, soci::into(answer);
      sql << "CREATE TABLE patients (id INTEGER PRIMARY KEY, code TEXT)";
    }
    expect_refused(folder, path, {OpenMode::create, OpenMode::existing, OpenMode::read_only},
                   "is a database of another program");
  }
}

TEST(OpenStore, NewerFormatIsReadButNotWritten) {
  TemporaryFolder folder;
  const std::string path = folder.file("newer.db");
  must(opened(path)->add_patient("P-1"));
  {
    soci::session sql(soci::sqlite3, path);
    sql << "PRAGMA user_version=" + std::to_string(kDatabaseFormat + 1);
  }
  expect_refused(folder, path, {OpenMode::create, OpenMode::existing},
                 "was made by a newer isograsp (format " + std::to_string(kDatabaseFormat + 1) +
                     ", this program knows " + std::to_string(kDatabaseFormat) + ")");
  EXPECT_EQ(must(opened(path, OpenMode::read_only)->patients()).size(), 1u);
}

TEST(OpenStore, ReadOnlyStoreRefusesToWrite) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  const std::string before = bytes_of(path);
  {
    const auto store = opened(path, OpenMode::read_only);
    EXPECT_FALSE(store->add_patient("P-1").ok());
    EXPECT_EQ(must(store->patients()).size(), 0u);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"clinic.db"}) << "leaves no journal";
}

TEST(OpenStore, ReadOnlyFileAndFolderAreRefusedForWriting) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  namespace fs = std::filesystem;
  fs::permissions(folder.path(), fs::perms(0777));
  fs::permissions(path, fs::perms(0444));
  EXPECT_TRUE(as_nobody([&] {
    const auto store = open_store(path, OpenMode::existing);
    return !store && english(store.error().what) == "is read-only";
  }));
  fs::permissions(path, fs::perms(0666));
  fs::permissions(folder.path(), fs::perms(0555));
  EXPECT_TRUE(as_nobody([&] {
    const auto store = open_store(path, OpenMode::existing);
    return !store && english(store.error().what) == "stands in a read-only folder";
  }));
  EXPECT_TRUE(as_nobody([&] {
    const auto store = open_store(folder.file("new.db"), OpenMode::create);
    return !store && english(store.error().what) == "its folder is read-only";
  }));
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"clinic.db"});
}

TEST(OpenStore, LockedDatabaseIsAnErrorAfterAWait) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto store = opened(path);
  soci::session other(soci::sqlite3, path);
  other << "BEGIN IMMEDIATE";
  const auto patient = store->add_patient("P-1");
  ASSERT_FALSE(patient.ok());
  EXPECT_NE(patient.error().message().find("is locked by another program"), std::string::npos)
      << patient.error().message();
  other << "ROLLBACK";
  EXPECT_TRUE(store->add_patient("P-1").ok());
}

TEST(OpenStore, ClosingOneStoreKeepsTheLocksOfAnotherInTheSameProcess) {
  TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto first = opened(path);
  must(first->add_patient("P-1"));
  opened(path, OpenMode::existing).reset();
  // A program that could take the last lock would have removed the journal under the first store.
  const pid_t child = fork();
  if (child == 0) {
    { soci::session(soci::sqlite3, path) << "SELECT 1 FROM patients"; }
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(std::filesystem::exists(path + "-wal"));
}

}  // namespace
}  // namespace isograsp::storage::open_test
