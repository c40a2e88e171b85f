// SPDX-License-Identifier: GPL-3.0-or-later
// Backups in time, their rotation, the way back, and what a file is made of.
#include "storage/care/backups.hpp"

#include <fstream>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/time.hpp"
#include "storage/access/open_store.hpp"
#include "storage/file/file_stats.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::backups_test {
namespace {
constexpr std::time_t kDay_s = 86400;
const std::time_t kStart = *time_of_utc("2026-01-05T17:00:00Z");  // a Monday

struct Backup : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");

  void SetUp() override {
    const auto store = opened(path);
    const RowId patient = must(store->add_patient("P-1")).id;
    TrialRecord trial = example_trial(must(store->begin_session(example_session(patient))));
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 30; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, static_cast<unsigned>(s))));
    trial.status = TrialStatus::completed;
    must(store->end_trial(trial, {}));
  }
  void execute(const std::string& statement) const {
    soci::session(soci::sqlite3, "db=\"" + path + "\"") << statement;
  }
  void damage() const { execute("UPDATE signal_packs SET values_blake2b = zeroblob(32)"); }
};

TEST(BackupRotation, KeepsTheNewestOfSevenDaysFourWeeksTwelveMonths) {
  // Every day for two years, twice a day.
  std::vector<std::time_t> times;
  for (int day = 730; day > 0; --day)
    for (const int hour : {14, 9}) times.push_back(kStart + day * kDay_s + hour * 3600);
  const auto kept = kept_by({}, times);
  std::vector<std::time_t> ages_days;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (kept[i]) {
      EXPECT_EQ(i % 2, 0u) << "the newer one of the day";
      ages_days.push_back((times[0] - times[i]) / kDay_s);
    }
  EXPECT_TRUE(kept[0]);
  for (int day = 0; day < 7; ++day) EXPECT_EQ(ages_days[static_cast<std::size_t>(day)], day);
  // Three weeks and eleven months beyond, of which some fall together.
  EXPECT_LE(ages_days.size(), 7u + 3u + 11u);
  EXPECT_GE(ages_days.size(), 7u + 2u + 10u);
  // The newest of the month eleven months ago: at least ten whole months lie between.
  EXPECT_GT(ages_days.back(), 300);
  EXPECT_LT(ages_days.back(), 366);
}

TEST(BackupRotation, OfWhatIsKeptKeepsAllOfIt) {
  std::vector<std::time_t> there;
  for (int day = 0; day < 400; ++day) {
    there.insert(there.begin(), kStart + day * kDay_s);
    const auto kept = kept_by({}, there);
    std::vector<std::time_t> next;
    for (std::size_t i = 0; i < there.size(); ++i)
      if (kept[i]) next.push_back(there[i]);
    EXPECT_EQ(kept_by({}, next), std::vector<bool>(next.size(), true));
    there = next;
  }
  EXPECT_LE(there.size(), 23u);
  EXPECT_GT((there.front() - there.back()) / kDay_s, 300) << "eleven months back, day by day";
}

TEST_F(Backup, IsDueOnceADayAndIsASoundCopy) {
  const Backups backups(path);
  EXPECT_TRUE(must(backups.due(kStart)));
  const auto made = must(backups.make_if_due(kStart));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->backup.path, path + ".backups/2026-01-05T170000Z.db");
  EXPECT_EQ(made->backup.made_utc, "2026-01-05T17:00:00Z");
  EXPECT_TRUE(must(opened(made->backup.path, OpenMode::read_only)->check()).empty());
  EXPECT_FALSE(must(backups.make_if_due(kStart + 3600)));
  EXPECT_TRUE(must(backups.due(kStart + kDay_s)));
  // The clock is set back: yesterday has none, and the one of tomorrow is no reason to wait.
  EXPECT_TRUE(must(backups.due(kStart - kDay_s)));
  EXPECT_TRUE(must(backups.make_if_due(kStart - kDay_s)).has_value());
  EXPECT_EQ(must(backups.list()).size(), 2u);
}

TEST_F(Backup, RotationRemovesOnlyWhatItMade) {
  const Backups backups(path, {2, 1, 1});
  std::filesystem::create_directory(backups.folder());
  const std::string somebodys = backups.folder() + "/2026-01-05.db";
  std::ofstream(somebodys) << "somebody's";
  for (int day = 0; day < 4; ++day) must(backups.make(kStart + day * kDay_s));
  const auto left = must(backups.list());
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].made_utc, "2026-01-08T17:00:00Z");
  EXPECT_EQ(left[1].made_utc, "2026-01-07T17:00:00Z");
  EXPECT_TRUE(std::filesystem::exists(somebodys));
}

TEST_F(Backup, OfADamagedDatabaseIsAnErrorAndNoGoodOneIsRemoved) {
  const Backups backups(path, {1, 0, 0});
  must(backups.make(kStart));
  damage();
  for (int day = 1; day < 4; ++day) EXPECT_FALSE(backups.make(kStart + day * kDay_s).ok());
  const auto left = must(backups.list());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_TRUE(must(opened(left[0].path, OpenMode::read_only)->check()).empty());
}

TEST_F(Backup, RestoringBringsBackWhatWasAndKeepsWhatIs) {
  const auto made = must(Backups(path).make(kStart));
  const std::string before = bytes_of(made.backup.path);
  must(opened(path)->add_patient("P-2"));
  const auto restored = must(restore_backup(made.backup.path, path));
  EXPECT_EQ(bytes_of(made.backup.path), before) << "a backup stays as it is";
  EXPECT_EQ(restored.kept, path + ".before-restore");
  EXPECT_EQ(must(opened(path)->patients()).size(), 1u);
  EXPECT_EQ(must(opened(restored.kept)->patients()).size(), 2u);
  must(opened(path)->add_patient("P-3"));
  EXPECT_EQ(must(restore_backup(made.backup.path, path)).kept, path + ".before-restore-2");
  EXPECT_EQ(must(opened(path + ".before-restore")->patients()).size(), 2u);
  EXPECT_TRUE(must(opened(made.backup.path, OpenMode::read_only)->check()).empty());
}

TEST_F(Backup, RestoringOverADamagedFileAndWhereThereIsNone) {
  const auto made = must(Backups(path).make(kStart));
  std::ofstream(path, std::ios::binary) << "not a database any more";
  must(restore_backup(made.backup.path, path));
  EXPECT_TRUE(must(opened(path)->check()).empty());
  EXPECT_EQ(bytes_of(path + ".before-restore"), "not a database any more");
  const std::string fresh = folder.file("fresh.db");
  EXPECT_EQ(must(restore_backup(made.backup.path, fresh)).kept, "");
  EXPECT_EQ(must(opened(fresh)->patients()).size(), 1u);
}

TEST_F(Backup, TheLogOfALostFileIsSetAsideNotReplayedIntoTheRestoredOne) {
  const auto made = must(Backups(path).make(kStart));
  const auto store = opened(path);  // keeps the log
  must(store->add_patient("P-2"));
  const std::string lost = folder.file("lost.db");
  std::filesystem::copy_file(path + "-wal", lost + "-wal");
  const std::string log = bytes_of(lost + "-wal");
  ASSERT_FALSE(log.empty());
  must(restore_backup(made.backup.path, lost));
  EXPECT_EQ(must(opened(lost)->patients()).size(), 1u);
  EXPECT_TRUE(must(opened(lost)->check()).empty());
  EXPECT_EQ(bytes_of(lost + ".before-restore-wal"), log);
}

TEST_F(Backup, IsNotRestoredIfItIsDamagedOrTheFileIsInUse) {
  const auto made = must(Backups(path).make(kStart));
  {
    const auto in_use = opened(path);
    must(in_use->patients());
    const auto refused = restore_backup(made.backup.path, path);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().message().find("another program has it open"), std::string::npos)
        << refused.error().message();
    must(in_use->add_patient("P-2"));
  }
  soci::session(soci::sqlite3, "db=\"" + made.backup.path + "\"")
      << "UPDATE signal_packs SET values_blake2b = zeroblob(32)";
  EXPECT_FALSE(restore_backup(made.backup.path, path).ok());
  EXPECT_FALSE(restore_backup(path, path).ok());
  EXPECT_EQ(must(opened(path)->patients()).size(), 2u);
  for (const auto& name : test::every(folder.listing()))
    EXPECT_EQ(name.find(".restored"), std::string::npos) << "nothing half made: " << name;
}

TEST_F(Backup, StatsCountWhatIsThere) {
  const auto stats = must(file_stats(path));
  EXPECT_EQ(stats.format, kDatabaseFormat);
  EXPECT_EQ(stats.patients, 1);
  EXPECT_EQ(stats.sessions, 1);
  EXPECT_EQ(stats.trials, 1);
  EXPECT_EQ(stats.trials_not_packed, 0);
  EXPECT_EQ(stats.recorded_s, 30.0);
  EXPECT_EQ(stats.values, 3000 * 4);
  EXPECT_EQ(stats.file_bytes, static_cast<std::int64_t>(std::filesystem::file_size(path)));
  EXPECT_GT(stats.signal_bytes, 0);
  EXPECT_LT(stats.signal_bytes, stats.file_bytes);
  EXPECT_EQ(stats.bytes_per_minute(),
            2.0 * static_cast<double>(stats.file_bytes - stats.free_bytes));
  EXPECT_EQ(stats.first_session_utc, "2026-03-01T09:30:00Z");
  const auto old = must(file_stats(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/format_1.db"));
  EXPECT_EQ(old.format, 1);
  EXPECT_EQ(old.trials_not_packed, old.trials);
  EXPECT_GT(old.signal_bytes, 0);
}

}  // namespace
}  // namespace isograsp::storage::backups_test
