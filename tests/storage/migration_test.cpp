// SPDX-License-Identifier: GPL-3.0-or-later
// A file that an older program made: read as it is, brought up to date only when asked, losing
// nothing. tests/data/format_N.db was made by the last program that wrote format N.
#include "storage/care/migration.hpp"

#include <map>
#include <thread>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/audit_log.hpp"
#include "storage/access/open_store.hpp"
#include "storage/file/database.hpp"
#include "tests/storage/examples.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::migration_test {
namespace {
namespace fs = std::filesystem;

/// Parameter: the old format.
struct Migration : testing::TestWithParam<int> {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::string format = std::to_string(GetParam());
  Migration() {
    fs::copy_file(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/format_" + format + ".db", path);
  }
};
INSTANTIATE_TEST_SUITE_P(OfFormat, Migration, testing::Range(1, kDatabaseFormat),
                         testing::PrintToStringParamName());

/// Everything that a reader can see of the only session.
struct Contents {
  SessionRecord session;
  std::vector<TrialRecord> trials;
  std::vector<InstrumentZeroRecord> zeros;
  std::vector<std::vector<Measure>> measures;
  std::vector<Signals> signals;
};

Contents contents_of(SessionStore& store) {
  Contents all;
  all.session = must(store.sessions(must(store.patients()).at(0).id)).at(0);
  all.trials = must(store.trials(all.session.id));
  all.zeros = must(store.zeros(all.session.id));
  for (const auto& trial : all.trials) {
    all.measures.push_back(must(store.measures(trial.id)));
    all.signals.push_back(must(store.signals(trial)));
  }
  return all;
}

void expect_same(const Contents& a, const Contents& b) {
  EXPECT_EQ(a.session.device_uri, b.session.device_uri);
  EXPECT_EQ(a.session.seed, b.session.seed);
  ASSERT_EQ(a.trials.size(), b.trials.size());
  ASSERT_EQ(a.zeros.size(), b.zeros.size());
  for (std::size_t i = 0; i < a.zeros.size(); ++i) {
    EXPECT_EQ(a.zeros[i].mean, b.zeros[i].mean);
    EXPECT_EQ(a.zeros[i].sd, b.zeros[i].sd);
  }
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    EXPECT_EQ(a.trials[i].task_text, b.trials[i].task_text);
    EXPECT_EQ(a.trials[i].health_json, b.trials[i].health_json);
    EXPECT_EQ(a.trials[i].zero_id, b.trials[i].zero_id);
    ASSERT_EQ(a.measures[i].size(), b.measures[i].size());
    for (std::size_t m = 0; m < a.measures[i].size(); ++m)
      EXPECT_EQ(a.measures[i][m].value, b.measures[i][m].value);
    ASSERT_EQ(a.signals[i].names(), b.signals[i].names());
    for (const auto& name : test::every(a.signals[i].names())) {
      const auto x = a.signals[i].column(name);
      const auto y = b.signals[i].column(name);
      ASSERT_EQ(x.size(), y.size());
      for (std::size_t row = 0; row < x.size(); ++row) EXPECT_TRUE(same_bits(x[row], y[row]));
    }
  }
}

std::map<std::string, std::string> schema_of(const std::string& path) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::map<std::string, std::string> statements;
  std::string name;
  std::string text;
  soci::statement select =
      (sql.prepare << "SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL", soci::into(name),
       soci::into(text));
  select.execute();
  while (select.fetch()) statements[name] = text;
  return statements;
}

TEST_P(Migration, AnOldFileIsNotOpenedForWritingAndStaysAsItWas) {
  const std::string before = bytes_of(path);
  for (const OpenMode how : {OpenMode::create, OpenMode::existing}) {
    const auto store = open_store(path, how);
    ASSERT_FALSE(store.ok());
    EXPECT_NE(
        store.error().message().find("older isograsp (format " + format + ", this program writes " +
                                     std::to_string(kDatabaseFormat) + ")"),
        std::string::npos)
        << store.error().message();
    EXPECT_NE(store.error().remedy.find("isograsp db migrate"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"clinic.db"});
}

TEST_P(Migration, AnOldFileIsReadAsItIs) {
  const auto store = must(open_store_to_read(path));
  const Contents all = contents_of(*store);
  EXPECT_EQ(all.trials.size(), 2u);
  EXPECT_GT(all.signals[0].rows(), 10u);
  EXPECT_FALSE(all.zeros.at(0).change_N.has_value());
  EXPECT_EQ(all.zeros[0].recorded_utc.empty(), GetParam() < 2);
  EXPECT_FALSE(all.trials[1].threshold_N[0].has_value());
  EXPECT_EQ(must(store->resting_forces(all.session.id)).empty(), GetParam() < 2);
  EXPECT_EQ(all.session.resumes_id, 0);
  const bool three = GetParam() >= 3;
  EXPECT_EQ(all.session.allowed, three ? "maximum" : "");
  EXPECT_EQ(all.session.ceiling_N, three ? std::optional(25.0) : std::nullopt);
  EXPECT_EQ(all.trials[1].place, three ? std::optional(TrialPlace{2, 0}) : std::nullopt);
  EXPECT_EQ(all.trials[1].helped, three);
  EXPECT_EQ(must(store->ratings(all.session.id)).size(), three ? 1u : 0u);
  const bool four = GetParam() >= 4;
  const RowId patient = all.session.patient_id;
  const PatientProfile told{Side::left, Hand::right, "2025-12-31", "a note", "a goal"};
  EXPECT_EQ(must(store->profile(patient)), four ? told : PatientProfile{});
  EXPECT_EQ(must(store->treatment_marks(patient)).size(), four ? 1u : 0u);
  EXPECT_EQ(must(store->clinical_scores(patient)).size(), four ? 1u : 0u);
  EXPECT_EQ(must(store->answers(all.session.id)).size(), four ? 1u : 0u);
  EXPECT_EQ(all.trials[1].display_age_s, four ? std::optional(0.021) : std::nullopt);
  EXPECT_EQ(all.trials[1].visual_gain_deg_per_N, four ? std::optional(0.5) : std::nullopt);
  const bool five = GetParam() >= 5;
  EXPECT_EQ(must(store->primary_measures(patient)).size(), five ? 1u : 0u);
  EXPECT_EQ(must(store->stable_periods(patient)).size(), five ? 1u : 0u);
  const bool six = GetParam() >= 6;
  EXPECT_EQ(all.session.uuid.empty(), !six);
  EXPECT_EQ(all.trials[1].signals_hash.empty(), !six);
  EXPECT_TRUE(must(store->stable_values({})).empty());
  EXPECT_EQ(must(store->recent_sessions(5)).size(), 1u);
  EXPECT_FALSE(must(store->progress(all.session.patient_id)).empty());
  EXPECT_TRUE(must(store->check()).empty());
}

TEST_P(Migration, KeepsEverythingAndLeavesACheckedCopy) {
  const Contents before = contents_of(*must(open_store(path, OpenMode::read_only)));
  const auto done = must(migrate_database(path));
  EXPECT_EQ(done.from, GetParam());
  EXPECT_EQ(done.copy, path + ".format-" + format);
  expect_same(before, contents_of(*must(open_store(done.copy, OpenMode::read_only))));
  const auto store = opened(path, OpenMode::existing);
  expect_same(before, contents_of(*store));
  EXPECT_TRUE(must(store->check()).empty());
  must(store->add_patient("P-2"));
  must(store->set_profile(before.session.patient_id, {Side::right, Hand::right, "", "", ""}));
  must(store->add_stable_period(before.session.patient_id,
                                {0, "2027-01-01", "2027-01-31", "", "Therapist 7", ""}));
  must(store->add_answers(before.session.id,
                          std::vector<SessionAnswer>{{"posture", "seat", "chair"}}));
}

TEST_P(Migration, PacksTheSignalsAndGivesNamesThatTwoCopiesShare) {
  fs::copy_file(path, folder.file("copy.db"));
  EXPECT_EQ(must(migrate_database(path)).packed, GetParam() >= 6 ? 0 : 2);
  must(migrate_database(folder.file("copy.db")));
  const auto one = opened(path);
  const auto other = opened(folder.file("copy.db"));
  const Contents all = contents_of(*one);
  const Contents copy = contents_of(*other);
  EXPECT_EQ(all.session.uuid.size(), 36u);
  EXPECT_EQ(all.session.uuid, copy.session.uuid);
  EXPECT_EQ(must(one->patients())[0].uuid, must(other->patients())[0].uuid);
  for (std::size_t i = 0; i < all.trials.size(); ++i) {
    EXPECT_EQ(all.trials[i].uuid, copy.trials[i].uuid);
    EXPECT_EQ(all.trials[i].signals_hash.size(), 64u);
    EXPECT_EQ(all.trials[i].signals_hash, copy.trials[i].signals_hash);
  }
  EXPECT_NE(all.trials[0].uuid, all.trials[1].uuid);
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  int blocks = -1;
  sql << "SELECT count(*) FROM signal_blocks", soci::into(blocks);
  EXPECT_EQ(blocks, 0);
}

TEST_P(Migration, OfADamagedTrialPacksTheOthersAndGoesOnLater) {
  must(migrate_database(path));
  const auto store = opened(path);
  TrialRecord trial = example_trial(must(store->sessions(1)).at(0).id, 9);
  trial.id = must(store->begin_trial(trial));
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  sql << "UPDATE trials SET status = 'interrupted', sample_count = 200 WHERE number = 9";
  const auto damaged = must(migrate_database(path));
  EXPECT_EQ(damaged.packed, 0);
  ASSERT_EQ(damaged.not_packed.size(), 1u);
  EXPECT_NE(damaged.not_packed[0].find("second 1: the block is missing"), std::string::npos);
  sql << "UPDATE trials SET sample_count = 100 WHERE number = 9";
  EXPECT_EQ(must(migrate_database(path)).packed, 1);
}

TEST_P(Migration, GivesTheSameTablesAsANewFile) {
  must(migrate_database(path));
  opened(folder.file("new.db"));
  EXPECT_EQ(schema_of(path), schema_of(folder.file("new.db")));
}

TEST_P(Migration, BeginsTheAuditLogWithItself) {
  must(migrate_database(path));
  const auto access = must(Access::open(path));
  EXPECT_FALSE(access->is_protected());
  const auto entries = must(read_audit(*access));
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].act, "migrate");
  EXPECT_EQ(entries[0].object, "clinic.db.format-" + format);
  EXPECT_TRUE(must(check_audit(*access)).empty());
}

TEST_P(Migration, IsDoneOnceAndNeverOverwritesACopy) {
  std::ofstream(path + ".format-" + format) << "somebody's";
  EXPECT_EQ(must(migrate_database(path)).copy, path + ".format-" + format + "-2");
  EXPECT_EQ(bytes_of(path + ".format-" + format), "somebody's");
  const auto again = must(migrate_database(path));
  EXPECT_EQ(again.from, kDatabaseFormat);
  EXPECT_EQ(again.copy, "");
}

TEST_P(Migration, IsRefusedWhileSomebodyRecords) {
  const auto recording = must(RecordingLock::shared(path));
  const std::string before = bytes_of(path);
  const auto refused = migrate_database(path);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("records into the file now"), std::string::npos);
  EXPECT_EQ(bytes_of(path), before);
}

}  // namespace
}  // namespace isograsp::storage::migration_test
