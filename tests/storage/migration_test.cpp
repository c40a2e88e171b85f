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
#include "storage/care/backups.hpp"
#include "storage/file/database.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/sealed_write.hpp"
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
  std::vector<PreparationRecord> preparations;
  std::vector<EventRecord> events;
  std::vector<RatingRecord> ratings;
  std::vector<std::vector<Measure>> measures;
  std::vector<Signals> signals;
};

Contents contents_of(SessionStore& store) {
  Contents all;
  all.session = must(store.sessions(must(store.patients()).at(0).id)).at(0);
  all.trials = must(store.trials(all.session.id));
  all.preparations = must(store.preparations(all.session.id));
  all.events = must(store.events(all.session.id));
  all.ratings = must(store.ratings(all.session.id));
  for (const auto& trial : all.trials) {
    all.measures.push_back(must(store.measures(trial.id)));
    all.signals.push_back(must(store.signals(trial)));
  }
  return all;
}

/// But UUIDs and hashes, which older files do not have.
void expect_same(const Contents& a, Contents b) {
  b.session.uuid = a.session.uuid;
  EXPECT_EQ(a.session, b.session);
  EXPECT_EQ(a.preparations, b.preparations);
  EXPECT_EQ(a.events, b.events);
  EXPECT_EQ(a.ratings, b.ratings);
  ASSERT_EQ(a.trials.size(), b.trials.size());
  for (std::size_t i = 0; i < a.trials.size(); ++i) {
    b.trials[i].uuid = a.trials[i].uuid;
    b.trials[i].signals_hash = a.trials[i].signals_hash;
    EXPECT_EQ(a.trials[i], b.trials[i]);
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
    EXPECT_NE(english(store.error().remedy).find("isograsp db migrate"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"clinic.db"});
}

TEST_P(Migration, AnOldFileIsReadAsItIs) {
  const auto store = must(open_store_to_read(path));
  const Contents all = contents_of(*store);
  EXPECT_EQ(all.trials.size(), 2u);
  EXPECT_GT(all.signals[0].rows(), 10u);
  EXPECT_EQ(all.preparations.at(0).kind, "instrument_zero");
  EXPECT_EQ(all.preparations[0].columns.size(), 18u);
  EXPECT_EQ(all.preparations[0].mean.size(), 18u);
  EXPECT_TRUE(all.preparations[0].references.empty());
  EXPECT_EQ(all.preparations[0].recorded_utc.empty(), GetParam() < 2);
  EXPECT_EQ(all.trials[1].preparations, std::vector{all.preparations[0].id});
  EXPECT_FALSE(all.trials[1].references.contains("thumb_threshold_N"));
  EXPECT_EQ(all.preparations.size(), GetParam() < 2 ? 1u : 2u) << "and the resting force";
  EXPECT_EQ(all.session.sensors.size(), GetParam() < 2 ? 0u : 3u);
  EXPECT_FALSE(all.session.resumes_id);
  const bool three = GetParam() >= 3;
  EXPECT_EQ(all.session.allowed, three ? "maximum" : "");
  EXPECT_EQ(value_of(all.session.references, "ceiling_N"),
            three ? std::optional(25.0) : std::nullopt);
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
  EXPECT_EQ(value_of(all.trials[1].references, "visual_gain_deg_per_N"),
            four ? std::optional(0.5) : std::nullopt);
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
  write_sealed(path,
               "UPDATE trials SET status = 'interrupted', sample_count = 200 WHERE number = 9");
  const auto damaged = must(migrate_database(path));
  EXPECT_EQ(damaged.packed, 0);
  ASSERT_EQ(damaged.not_packed.size(), 1u);
  EXPECT_NE(english(damaged.not_packed[0]).find("second 1: the block is missing"),
            std::string::npos);
  write_sealed(path, "UPDATE trials SET sample_count = 100 WHERE number = 9");
  EXPECT_EQ(must(migrate_database(path)).packed, 1);
}

TEST_P(Migration, GivesTheSameTablesAsANewFile) {
  must(migrate_database(path));
  opened(folder.file("new.db"));
  EXPECT_EQ(schema_of(path), schema_of(folder.file("new.db")));
}

TEST_P(Migration, IsAnEntryOfTheAuditLogTheFirstWhereThereWasNone) {
  must(migrate_database(path));
  const auto access = must(Access::open(path));
  EXPECT_FALSE(access->is_protected());
  const auto entries = must(read_audit(*access));
  // From 7 on the files say where they came from themselves.
  ASSERT_EQ(static_cast<int>(entries.size()), 1 + std::max(0, GetParam() - 6));
  EXPECT_EQ(entries.back().act, "migrate");
  EXPECT_EQ(entries.back().object, "clinic.db.format-" + format);
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

/// tests/data/format_7_session.db: two whole sessions of the last program that wrote format 7.
struct ForceSessions : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  ForceSessions() { fs::copy_file(ISOGRASP_SOURCE_DIR "/tests/data/format_7_session.db", path); }
};

TEST_F(ForceSessions, OfFormat7KeepZeroRestReferencesSensorsAndDrift) {
  for (const bool migrated : {false, true}) {
    if (migrated) must(migrate_database(path));
    const auto store = must(open_store_to_read(path));
    const auto sessions = must(store->recent_sessions(9));
    ASSERT_EQ(sessions.size(), 2u);
    const SessionRecord& first = sessions[1];
    EXPECT_EQ(first.references, (References{{"ceiling_N", 30.0}}));
    EXPECT_EQ(first.sensors,
              (std::vector<SensorRecord>{
                  {"thumb", "SIM-THUMB"}, {"index", "SIM-INDEX"}, {"middle", "SIM-MIDDLE"}}));
    const auto done = must(store->preparations(first.id));
    ASSERT_EQ(done.size(), 3u);
    EXPECT_EQ(done[0].kind, "instrument_zero");
    EXPECT_EQ(done[0].columns.front(), "thumb_fx_N");
    EXPECT_EQ(done[0].columns.back(), "middle_tz_Nm");
    EXPECT_FALSE(done[0].drifted);
    EXPECT_EQ(done[1].references, (References{{"change_N", 0.5}, {"drift_N", 0.5}}));
    EXPECT_TRUE(done[1].change_confirmed);
    EXPECT_TRUE(done[1].drifted);
    EXPECT_EQ(done[2].kind, "resting_force");
    EXPECT_EQ(done[2].references, (References{{"duration_s", 2.0}}));
    EXPECT_EQ(done[2].samples, 200);
    const auto trials = must(store->trials(first.id));
    ASSERT_EQ(trials.size(), 3u);
    EXPECT_EQ(done[2].trial_id, trials[0].id);
    for (const TrialRecord& trial : trials) {
      EXPECT_EQ(trial.preparations, std::vector{done[0].id});
      EXPECT_EQ(trial.drift, (References{{"drift_N", 0.5}}));
      EXPECT_TRUE(trial.drifted);
    }
    EXPECT_TRUE(trials[0].references.empty()) << "0 stood for what was not measured";
    EXPECT_EQ(trials[2].references.size(), 5u);
    EXPECT_EQ(trials[2].references.at("index_threshold_N"), 0.49318879999999954);
    EXPECT_EQ(must(store->last_preparation(first, "instrument_zero"))->id, done[1].id);
    EXPECT_TRUE(must(store->trials(sessions[0].id))[1].drift.empty());
    EXPECT_TRUE(must(store->check()).empty());
  }
}

/// tests/data/format_8_protected.db: made by the last program that wrote format 8.
TEST(MigrationOfAProtectedFile, AsksForALoginThatMayWriteAndKeepsEverything) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  fs::copy_file(ISOGRASP_SOURCE_DIR "/tests/data/format_8_protected.db", path);
  const auto secret = [](const char* text) { return Secret{std::string_view(text)}; };
  const std::string before = bytes_of(path);
  EXPECT_NE(english(migrate_database(path).error().what).find("nobody is logged in"),
            std::string::npos);
  {
    const auto access = must(Access::open_to_migrate(path));
    EXPECT_FALSE(access->log_in("Rita", secret("theo's password")).ok());
    must(access->log_in("Rita", secret("rita's password")));
    EXPECT_NE(english(migrate_database(path).error().what).find("researcher"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(path), before);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"clinic.db"}) << "no copy either";
  {
    const auto access = must(Access::open_to_migrate(path));
    must(access->log_in("Theo", secret("theo's password")));
    EXPECT_EQ(must(migrate_database(path)).from, 8);
  }
  const auto access = must(Access::open(path));
  must(access->log_in("Ada", secret("ada's password")));
  EXPECT_EQ(must(read_audit(*access, {"migrate", ""})).at(0).actor, "Theo");
  const auto store = opened(path, OpenMode::existing);
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
  EXPECT_EQ(must(store->profile(1)).notes, "a note");
  EXPECT_EQ(must(store->treatment_marks(1)).at(0).text, "a mark");
  EXPECT_EQ(must(read_identity(*access, "P-0427"))->name, "Vera Novak");
}

/// Nobody logs in to an older format, so nothing is read of it before.
TEST(MigrationOfAProtectedFile, StandsBeforeReadingAndRestoring) {
  const TemporaryFolder folder;
  const std::string backup = folder.file("backup.db");
  const std::string path = folder.file("clinic.db");
  fs::copy_file(ISOGRASP_SOURCE_DIR "/tests/data/format_8_protected.db", backup);
  EXPECT_FALSE(open_store(backup, OpenMode::read_only).ok());
  const auto opened_so = Access::open(backup);
  ASSERT_FALSE(opened_so.ok());
  EXPECT_NE(opened_so.error().message().find("isograsp db migrate"), std::string::npos);
  const auto refused = restore_backup(backup, path);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().message().find("run isograsp db migrate on a copy of it"),
            std::string::npos)
      << refused.error().message();
  EXPECT_FALSE(fs::exists(path));
  const auto log_in = [](const std::string& file) -> Result<std::unique_ptr<Access>> {
    auto access = must(Access::open(file));
    must(access->log_in("Theo", Secret{std::string_view("theo's password")}));
    return access;
  };
  {
    const auto access = must(Access::open_to_migrate(backup));
    must(access->log_in("Theo", Secret{std::string_view("theo's password")}));
    must(migrate_database(backup));
  }
  must(restore_backup(backup, path, log_in));
  const auto access = must(log_in(path));
  EXPECT_TRUE(must(opened(path)->check()).empty());
}

TEST_P(Migration, SealsWhatItFinds) {
  must(migrate_database(path));
  EXPECT_TRUE(must(opened(path)->check()).empty());
  soci::session(soci::sqlite3, "db=\"" + path + "\"") << "UPDATE trials SET helped = 1 - helped "
                                                         "WHERE id = 1";
  const auto problems = must(opened(path)->check());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(english(problems[0]), "trials: row 1 is not what isograsp wrote");
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
