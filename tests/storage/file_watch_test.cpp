// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a file while a program records into it: nothing is called stored that is not.
#include <fstream>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/care/emergency.hpp"
#include "tests/storage/examples.hpp"

namespace isograsp::storage::file_watch_test {
namespace {

namespace fs = std::filesystem;

void overwrite(const std::string& path, std::streamoff from, const std::string& bytes) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(from);
  file << bytes;
}

/// A trial with three seconds; whether the fourth and the end of the trial are taken afterwards.
struct Recording {
  explicit Recording(const std::string& name) : path(folder.file(name)) {
    store = opened(path);
    const auto patient = must(store->add_patient("P-1"));
    session = must(store->begin_session(example_session(patient.id)));
    trial = example_trial(session);
    trial.id = must(store->begin_trial(trial));
    for (int second = 0; second < 3; ++second)
      must(store->append_blocks(trial.id, second, example_rows(trial, 100, second)));
  }
  Result<void> append() { return store->append_blocks(trial.id, 3, example_rows(trial, 100, 3)); }

  TemporaryFolder folder;
  std::string path;
  std::unique_ptr<SessionStore> store;
  RowId session = 0;
  TrialRecord trial;
};

struct FileFault {
  const char* name;
  void (*strike)(const std::string& path);
  const char* words;
};

const FileFault kFaults[]{
    {"deleted", [](const std::string& path) { fs::remove(path); }, "deleted or moved away"},
    {"moved", [](const std::string& path) { fs::rename(path, path + ".away"); },
     "deleted or moved away"},
    {"replaced",
     [](const std::string& path) {
       fs::copy_file(path, path + ".new");
       fs::rename(path + ".new", path);
     },
     "another file was put in its place"},
    {"moved, a link in its place",
     [](const std::string& path) {
       fs::rename(path, path + ".away");
       fs::create_symlink(path + ".away", path);
     },
     "another file was put in its place"},
    {"emptied", [](const std::string& path) { fs::resize_file(path, 0); }, "emptied"},
    {"cut off", [](const std::string& path) { fs::resize_file(path, fs::file_size(path) / 2); },
     "cut off"},
    {"overwritten with a text",
     [](const std::string& path) { std::ofstream(path) << "nothing of use\n"; }, "overwritten"},
    {"overwritten in the middle",
     [](const std::string& path) { overwrite(path, 9000, std::string(5000, 'x')); },
     "something else wrote into the file"},
    {"log deleted", [](const std::string& path) { fs::remove(path + "-wal"); },
     "the write-ahead log (-wal) beside the file was deleted"},
    {"log replaced",
     [](const std::string& path) {
       fs::copy_file(path + "-wal", path + "-new");
       fs::rename(path + "-new", path + "-wal");
     },
     "the write-ahead log (-wal) beside the file was replaced"},
    {"log emptied", [](const std::string& path) { fs::resize_file(path + "-wal", 0); },
     "cut off or overwritten"},
    {"log overwritten",
     [](const std::string& path) {
       overwrite(path + "-wal", 0, std::string(fs::file_size(path + "-wal"), 'x'));
     },
     "cut off or overwritten"},
    {"index deleted", [](const std::string& path) { fs::remove(path + "-shm"); }, "(-shm)"},
    {"lock deleted", [](const std::string& path) { fs::remove(path + "-lock"); }, "(-lock)"},
    {"lock replaced",
     [](const std::string& path) {
       fs::remove(path + "-lock");
       std::ofstream(path + "-lock") << "";
     },
     "(-lock)"},
};

TEST(FileWatch, NothingIsConfirmedOnceTheFileOrItsCompanionsAreNotWhatWasOpened) {
  for (const FileFault& fault : kFaults) {
    Recording recording("clinic.db");
    must(recording.store->in_place());
    fault.strike(recording.path);
    const auto seen = recording.store->in_place();
    const auto stored = recording.append();
    ASSERT_FALSE(stored.ok()) << fault.name;
    EXPECT_NE(stored.error().message().find(fault.words), std::string::npos)
        << fault.name << ": " << stored.error().message();
    EXPECT_EQ(stored.error().file, recording.path);
    EXPECT_EQ(stored.error().code, Error::Code::failed);
    EXPECT_FALSE(recording.append().ok()) << fault.name << ": it stays so";
    // What a log holds can only be judged while nobody writes it.
    const std::string name = fault.name;
    if (name != "log emptied" && name != "log overwritten") {
      EXPECT_FALSE(seen.ok()) << name;
    }
  }
}

TEST(FileWatch, AMovedFileHoldsAllThatWasConfirmedAndNoLogIsLeftForAnother) {
  Recording recording("clinic.db");
  fs::rename(recording.path, recording.path + ".away");
  EXPECT_FALSE(recording.append().ok());
  EXPECT_EQ(fs::file_size(recording.path + "-wal"), 0u);
  recording.store.reset();
  const auto store = opened(recording.path + ".away", OpenMode::existing);
  const auto trial = must(store->trials(recording.session)).at(0);
  EXPECT_EQ(trial.samples, 300);
  EXPECT_EQ(must(store->signals(trial)).rows(), 300u);
}

TEST(FileWatch, ALogThatIsDeletedCostsNothingThatWasConfirmed) {
  Recording recording("clinic.db");
  fs::remove(recording.path + "-wal");
  EXPECT_FALSE(recording.append().ok());
  recording.store.reset();
  const auto store = opened(recording.path, OpenMode::existing);
  EXPECT_EQ(must(store->signals(must(store->trials(recording.session)).at(0))).rows(), 300u);
  EXPECT_TRUE(must(store->check()).empty());
}

TEST(FileWatch, OtherProgramsThatReadWriteAndCheckpointAreNoFault) {
  Recording recording("clinic.db");
  for (int round = 0; round < 20; ++round) {
    const auto other = opened(recording.path, OpenMode::existing);
    for (int k = 0; k < 5; ++k)
      must(other->add_patient("Q-" + std::to_string(round) + "-" + std::to_string(k)));
    soci::session sql(soci::sqlite3, "db=\"" + recording.path + "\"");
    sql << (round % 3 == 0   ? "PRAGMA wal_checkpoint(TRUNCATE)"
            : round % 3 == 1 ? "PRAGMA wal_checkpoint(PASSIVE)"
                             : "VACUUM");
    must(recording.store->in_place());
    must(recording.store->append_blocks(recording.trial.id, 3 + round,
                                        example_rows(recording.trial, 100, round)));
  }
  TrialRecord end = recording.trial;
  end.status = TrialStatus::completed;
  must(recording.store->end_trial(end, {}));
}

TEST(PutBack, ACopyTakesThePlaceOfADeletedFileAndTouchesNoOtherFile) {
  const TemporaryFolder folder;
  const std::string database = folder.file("clinic.db");
  EmergencyFile emergency;
  emergency.path = folder.file("emergency.db");
  emergency.has_whole = true;
  std::ofstream(emergency.whole()) << "the whole";
  std::ofstream(database + ".part") << "of somebody else, or of a copy that was broken off";
  const auto done = put_back(database, emergency);
  ASSERT_TRUE(done.ok()) << done.error().message();
  EXPECT_EQ(std::filesystem::file_size(database), std::filesystem::file_size(emergency.whole()));
  EXPECT_GT(std::filesystem::file_size(database + ".part"), 0u);
}

TEST(FileWatch, ATrialThatAnotherProgramHasClosedIsNotEndedOnceMore) {
  Recording recording("clinic.db");
  soci::session sql(soci::sqlite3, "db=\"" + recording.path + "\"");
  sql << "UPDATE trials SET status = 'interrupted', sample_count = 300";
  TrialRecord end = recording.trial;
  end.status = TrialStatus::completed;
  const auto ended = recording.store->end_trial(end, {});
  ASSERT_FALSE(ended.ok());
  EXPECT_NE(english(ended.error().what).find("another program has closed"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::storage::file_watch_test
