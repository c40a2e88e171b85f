// SPDX-License-Identifier: GPL-3.0-or-later
// The copy of the day: made beside the database, never begun in a session, and its failure told.
#include "gui/clinic/backup_work.hpp"

#include <QSignalSpy>
#include <filesystem>

#include "qt_test.hpp"
#include "storage/access/open_store.hpp"
#include "storage/records/session_store.hpp"
#include "tests/support/temporary_folder.hpp"

namespace isograsp::gui::test::backup_work_test {
namespace {

class BackupWorkTest : public QtTest {
 protected:
  TemporaryFolder folder_;
  std::string database_ = folder_.path("clinic.db");
};

TEST_F(BackupWorkTest, MakesOneAndNoneWhileASessionHoldsIt) {
  ASSERT_TRUE(storage::open_store(database_, storage::OpenMode::create).ok());
  BackupWork work(database_);
  QSignalSpy made(&work, &BackupWork::made);
  work.hold(true);
  work.look();
  work.hold(false);
  EXPECT_FALSE(std::filesystem::exists(storage::Backups(database_).folder()));
  work.look();
  ASSERT_TRUE(wait_until([&] { return made.count() == 1; }));
  EXPECT_TRUE(std::filesystem::exists(made.front().front().toString().toStdString()));
  EXPECT_TRUE(work.problem().isEmpty());
}

TEST_F(BackupWorkTest, AFailureIsToldAndStaysKnownUntilOneIsMade) {
  folder_.write("clinic.db", "no database");
  BackupWork work(database_);
  QSignalSpy failed(&work, &BackupWork::failed);
  QSignalSpy made(&work, &BackupWork::made);
  work.look();
  ASSERT_TRUE(wait_until([&] { return !work.problem().isEmpty(); }));
  EXPECT_EQ(failed.count(), 1);
  std::filesystem::remove(database_);
  ASSERT_TRUE(storage::open_store(database_, storage::OpenMode::create).ok());
  work.look();
  ASSERT_TRUE(wait_until([&] { return made.count() == 1; }));
  EXPECT_TRUE(work.problem().isEmpty());
  EXPECT_EQ(failed.count(), 1);
}

}  // namespace
}  // namespace isograsp::gui::test::backup_work_test
