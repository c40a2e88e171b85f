// SPDX-License-Identifier: GPL-3.0-or-later
// Erasure on request: restricted while the law asks for it, then gone to the last byte; consent.
#include "storage/person/erasure.hpp"

#include <set>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/login.hpp"
#include "storage/care/backups.hpp"
#include "storage/care/merge.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/storage/sealed_write.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::erasure_test {
namespace {

/// Rows in every table that a person can have rows in.
void fill(const std::string& path, const std::string& code, const std::string& mark,
          unsigned seed) {
  const auto store = opened(path);
  const RowId patient = must(store->add_patient(code, "2020-01-01T08:00:00Z")).id;
  must(store->set_profile(patient, {{}, {}, "", "note " + mark, "goal " + mark}));
  must(store->add_treatment_mark(patient, {0, "2020-01-20", "drug", "text " + mark}));
  must(store->add_clinical_score(patient, {0, "2020-01-20", "ARAT", 31.0, "muscle " + mark}));
  must(store->add_primary_measure(
      patient, {0, "Sine", Hand::left, "rmse", "force", "2020-01-20T08:00:00Z", "by " + mark}));
  must(store->add_stable_period(
      patient, {0, "2020-01-02", "2020-01-31", "2020-02-01T08:00:00Z", "judge " + mark, "why"}));
  SessionRecord session = example_session(patient);
  session.device_uri = "sim://" + mark;
  session.started_utc = "2020-02-28T08:00:00Z";
  const RowId session_id = must(store->begin_session(
      session, std::vector<SessionAnswer>{{"posture", "seat", "chair " + mark}}));
  PreparationRecord zero = example_preparation(session_id);
  zero.operator_name = "operator " + mark;
  zero.references = {{"change_N", 0.5}};
  TrialRecord trial = example_trial(session_id);
  trial.preparations = {must(store->add_preparation(zero))};
  trial.task_name = "task " + mark;
  trial.id = must(store->begin_trial(trial));
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, seed)));
  trial.status = TrialStatus::completed;
  Measure measure;
  measure.name = "rmse";
  measure.reason = "reason " + mark;
  must(store->end_trial(trial, std::vector<Measure>{measure}));
  PreparationRecord rest = example_preparation(session_id);
  rest.kind = "resting_force";
  rest.trial_id = trial.id;
  rest.operator_name = "rest " + mark;
  must(store->add_preparation(rest));
  must(store->add_event(session_id, {trial.id, 1.0, "note", "event " + mark}));
  RatingRecord rating;
  rating.session_id = session_id;
  rating.recorded_utc = mark;
  must(store->add_rating(rating));
  must(store->end_session(session_id, "2020-02-29T08:00:00Z"));
}

struct Erasure : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");
  std::unique_ptr<Access> access;
  Erasure() {
    fill(path, "P-1", "FORGETME", 1);
    fill(path, "P-2", "KEEPME", 2);
    access = must(Access::open(path));
    must(add_consent(*access, "P-1",
                     {0, "2020-01-05", "research", "consent", "given", "FORGETME form", "", ""}));
    execute("UPDATE consents SET recorded_utc = '2020-01-05T08:00:00Z'");
  }
  void execute(const std::string& statement) const { write_sealed(path, statement); }
  /// Of both people, in the database and everything beside it.
  [[nodiscard]] bool anywhere(const std::string& text) const {
    for (const std::string& name : folder.listing())
      if (bytes_of(folder.file(name)).find(text) != std::string::npos) return true;
    return false;
  }
};

TEST_F(Erasure, NamesEveryTableThatHangsOnAPerson) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  // As after a merge, and while a trial is recorded.
  sql << "INSERT INTO patient_aliases (uuid, patient_id) SELECT substr(uuid, 1, 35) || 'z', id "
         "FROM patients";
  sql << "INSERT INTO signal_blocks SELECT trial_id, position, 0, 1, 0, x'00' FROM signal_groups";
  std::set<std::string> personal{"patients"};
  for (std::size_t before = 0; before != personal.size();) {
    before = personal.size();
    std::string table;
    std::string parent;
    soci::statement select =
        (sql.prepare << "SELECT t.name, f.\"table\" FROM sqlite_schema t "
                        "JOIN pragma_foreign_key_list(t.name) f WHERE t.type = 'table'",
         soci::into(table), soci::into(parent));
    select.execute();
    while (select.fetch())
      if (personal.contains(parent)) personal.insert(table);
  }
  const auto rows = [&](const std::string& table) {
    int count = 0;
    sql << "SELECT count(*) FROM " + table, soci::into(count);
    return count;
  };
  std::map<std::string, int> before;
  for (const auto& table : personal) before[table] = rows(table);
  const std::set<std::string> filled_elsewhere{"identities", "restrictions", "consents"};
  for (const auto& [table, count] : test::every(before)) {
    EXPECT_TRUE(count >= 2 || filled_elsewhere.contains(table))
        << table
        << " is not filled by this test: fill it, and see that storage/person/erasure.cpp erases "
        << "it";
  }
  must(set_policy(*access, {600, 0}));
  must(erase_patient(*access, "P-1", "asked for it"));
  for (const auto& [table, count] : test::every(before))
    EXPECT_EQ(rows(table), table == "consents" ? 0 : count / 2) << table;
}

TEST_F(Erasure, LeavesNoByteInTheFileOrItsJournal) {
  must(set_policy(*access, {600, 0}));
  ASSERT_TRUE(anywhere("FORGETME"));
  const auto done = must(erase_patient(*access, "P-1", "asked for it"));
  EXPECT_TRUE(done.erased);
  EXPECT_FALSE(anywhere("FORGETME"));
  EXPECT_TRUE(anywhere("KEEPME"));
  const auto store = opened(path);
  EXPECT_TRUE(must(store->check()).empty());
  const auto patients = must(store->patients());
  ASSERT_EQ(patients.size(), 1u);
  const auto sessions = must(store->sessions(patients[0].id));
  EXPECT_EQ(must(store->signals(must(store->trials(sessions.at(0).id)).at(0))).rows(), 100u);
}

TEST_F(Erasure, LeavesATombstoneAndTheCodeIsNotGivenAgain) {
  must(set_policy(*access, {600, 0}));
  must(erase_patient(*access, "P-1", "asked for it"));
  const auto stones = must(tombstones(*access));
  ASSERT_EQ(stones.size(), 1u);
  EXPECT_EQ(stones[0].code, "P-1");
  EXPECT_NE(refusal(opened(path)->add_patient("p-1")).find("was erased"), std::string::npos);
}

TEST_F(Erasure, OfACodeThatWasErasedRewritesTheFileThatCouldNotBe) {
  must(opened(path)->backup(folder.file("monday.db")));
  must(set_policy(*access, {600, 0}));
  soci::session reader(soci::sqlite3, "db=\"" + path + "\"");
  int count = 0;
  reader << "BEGIN";
  reader << "SELECT count(*) FROM patients", soci::into(count);
  access->parts().database.sql() << "PRAGMA busy_timeout=0";
  const auto hindered = must(erase_patient(*access, "P-1", "asked for it"));
  EXPECT_TRUE(hindered.erased);
  ASSERT_TRUE(hindered.not_swept);
  EXPECT_NE(hindered.not_swept->message().find("another program reads"), std::string::npos);
  EXPECT_EQ(hindered.remains.size(), 1u) << "is told in any case";
  EXPECT_TRUE(anywhere("FORGETME"));
  reader << "COMMIT";
  const auto again = must(erase_patient(*access, "p-1", "once more"));
  EXPECT_TRUE(again.erased);
  EXPECT_FALSE(again.not_swept);
  EXPECT_TRUE(again.rows.empty());
  EXPECT_EQ(again.remains, hindered.remains);
  std::filesystem::remove(folder.file("monday.db"));
  EXPECT_FALSE(anywhere("FORGETME"));
  EXPECT_EQ(must(tombstones(*access)).size(), 1u);
}

TEST_F(Erasure, RestrictsWhileTheLawAsksForTheRecords) {
  const auto plan = must(plan_erasure(*access, "P-1"));
  EXPECT_EQ(plan.last_record_date, "2020-02-29");
  EXPECT_EQ(plan.keep_until_date, "2030-03-01");
  EXPECT_FALSE(plan.may_erase);
  const auto done = must(erase_patient(*access, "P-1", "asked for it"));
  EXPECT_FALSE(done.erased);
  EXPECT_TRUE(must(is_restricted(*access, "P-1")));
  const auto store = opened(path);
  const RowId patient = must(store->find_patient("P-1"))->id;
  EXPECT_FALSE(must(store->may_be_used_for_research(patient)));
  EXPECT_NE(refusal(store->begin_session(example_session(patient))).find("restricted until"),
            std::string::npos);
  must(lift_restriction(*access, "P-1", "wishes to go on"));
  must(store->begin_session(example_session(patient)));
}

TEST_F(Erasure, CountsTheYearsFromTheNewestRecordOfAnyKind) {
  must(set_policy(*access, {600, 1}));
  for (const auto& [statement, day] : std::vector<std::pair<std::string, std::string>>{
           {"UPDATE clinical_scores SET on_date = '2020-03-01'", "2020-03-01"},
           {"UPDATE treatment_marks SET on_date = '2020-03-02'", "2020-03-02"},
           {"UPDATE stable_periods SET until_date = '2020-03-03'", "2020-03-03"},
           {"UPDATE stable_periods SET judged_utc = '2020-03-04T08:00:00Z'", "2020-03-04"},
           {"UPDATE primary_measures SET chosen_utc = '2020-03-05T08:00:00Z'", "2020-03-05"},
           {"UPDATE consents SET recorded_utc = '2020-03-06T08:00:00Z'", "2020-03-06"},
           {"INSERT INTO identities SELECT id, '2020-03-07T08:00:00Z', '' FROM patients",
            "2020-03-07"},
           {"UPDATE patients SET created_utc = '2020-03-08T08:00:00Z'", "2020-03-08"},
           {"UPDATE sessions SET started_utc = '2020-03-09T08:00:00Z'", "2020-03-09"}}) {
    execute(statement);
    EXPECT_EQ(must(plan_erasure(*access, "P-1")).last_record_date, day) << statement;
  }
  execute("UPDATE clinical_scores SET on_date = strftime('%Y-%m-%d', 'now')");
  EXPECT_FALSE(must(plan_erasure(*access, "P-1")).may_erase) << "a score of today";
}

/// A column that says when a row was made is not forgotten in the reckoning of the years.
TEST_F(Erasure, KnowsEveryDateThatIsToldOfAPerson) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  std::set<std::string> dates;
  std::string column;
  soci::statement select =
      (sql.prepare
           << "SELECT t.name || '.' || c.name FROM sqlite_schema t "
              "JOIN pragma_table_info(t.name) c WHERE t.type = 'table' AND "
              "(c.name LIKE '%\\_utc' ESCAPE '\\' OR c.name LIKE '%\\_date' ESCAPE '\\') "
              "AND (t.name = 'patients' OR EXISTS (SELECT 1 FROM pragma_table_info(t.name) p "
              "WHERE p.name = 'patient_id'))",
       soci::into(column));
  select.execute();
  while (select.fetch()) dates.insert(column);
  // Not a record: the day of the stroke, when the erasure was asked for, and beginnings of what has
  // an end; the day of a consent is before it was recorded.
  EXPECT_EQ(
      dates,
      (std::set<std::string>{
          "clinical_scores.on_date", "consents.on_date", "consents.recorded_utc",
          "identities.changed_utc", "patient_profiles.onset_date", "patients.created_utc",
          "primary_measures.chosen_utc", "restrictions.since_utc", "restrictions.until_date",
          "sessions.ended_utc", "sessions.started_utc", "stable_periods.from_date",
          "stable_periods.judged_utc", "stable_periods.until_date", "treatment_marks.on_date"}))
      << "see whether storage/person/erasure.cpp counts the new one";
}

TEST_F(Erasure, ErasesAfterTheLastDayThatTheLawAsksFor) {
  must(set_policy(*access, {600, 1}));
  const auto plan = must(plan_erasure(*access, "P-1"));
  EXPECT_EQ(plan.keep_until_date, "2021-03-01");
  EXPECT_TRUE(plan.may_erase);
  EXPECT_TRUE(must(erase_patient(*access, "P-1", "asked for it")).erased);
}

TEST_F(Erasure, SaysWhatRemainsInBackupsAndExports) {
  must(opened(path)->backup(folder.file("monday.db")));
  const auto scheduled = must(Backups(path).make(std::time(nullptr))).backup.path;
  must(log_act(*access, "export", "", true, "csv"));
  must(log_act(*access, "report", "P-2", true, "pdf"));
  must(log_act(*access, "report", "p-1", true, "pdf"));
  must(log_act(*access, "study", "", true));
  must(log_act(*access, "restore", "", true, "sunday.db; as it was: clinic.db.before-restore"));
  const std::string station = folder.file("station.db");
  opened(station);
  must(merge_databases(path, station));
  must(set_policy(*access, {600, 0}));
  const auto done = must(erase_patient(*access, "P-1", "asked for it"));
  const std::vector<std::string> expected{"monday.db", std::filesystem::path(scheduled).filename(),
                                          "export",    "report",
                                          "study",     "clinic.db.before-restore",
                                          "station.db"};
  ASSERT_EQ(done.remains.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NE(done.remains[i].find(expected[i]), std::string::npos) << done.remains[i];
}

TEST_F(Erasure, WaitsForARecording) {
  must(set_policy(*access, {600, 0}));
  const auto store = opened(path);
  const RowId patient = must(store->find_patient("P-2"))->id;
  must(store->begin_trial(example_trial(must(store->begin_session(example_session(patient))))));
  EXPECT_NE(refusal(erase_patient(*access, "P-1", "asked for it")).find("records into the file"),
            std::string::npos);
  EXPECT_TRUE(must(store->find_patient("P-1")).has_value());
}

TEST_F(Erasure, AsksForAReasonOfOneLine) {
  EXPECT_FALSE(erase_patient(*access, "P-1", "").ok());
  EXPECT_FALSE(erase_patient(*access, "P-1", "two\nlines").ok());
  EXPECT_FALSE(erase_patient(*access, "P-1", std::string(201, 'x')).ok());
}

TEST_F(ProtectedClinic, ARestrictedIdentityIsSeenInAnEmergencyOnlyAndThatIsLogged) {
  must(opened(path)->add_patient("P-1"));
  must(set_identity(*access, "P-1", {"Vera", "", ""}));
  must(erase_patient(*access, "P-1", "asked for it"));
  as("Theo");
  EXPECT_NE(refusal(read_identity(*access, "P-1")).find("restricted until"), std::string::npos);
  EXPECT_TRUE(must(all_identities(*access)).empty());
  EXPECT_EQ(must(read_identity(*access, "P-1", "fell in the corridor"))->name, "Vera");
  EXPECT_FALSE(erase_patient(*access, "P-1", "a therapist may not").ok());
  as("Ada");
  const auto entries = must(read_audit(*access, {"emergency access", ""}));
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].actor, "Theo");
  EXPECT_EQ(entries[0].detail, "fell in the corridor");
}

TEST_F(ProtectedClinic, ErasureTakesTheIdentityToo) {
  must(opened(path)->add_patient("P-1"));
  must(set_identity(*access, "P-1", {"Vera", "", ""}));
  std::string sealed;
  {
    soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
    sql << "SELECT sealed FROM identities", soci::into(sealed);
  }
  must(set_policy(*access, {600, 0}));
  must(erase_patient(*access, "P-1", "asked for it"));
  for (const auto& name : test::every(folder.listing()))
    EXPECT_EQ(bytes_of(folder.file(name)).find(sealed.substr(20, 40)), std::string::npos) << name;
  EXPECT_TRUE(must(check_audit(*access)).empty());
}

TEST_F(ProtectedClinic, TheLastWordOnAPurposeCounts) {
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  const auto say = [&](const char* purpose, const char* state) {
    must(add_consent(*access, "P-1",
                     {0, "2026-03-05", purpose, "consent", state, "SECRETFORM", "", ""}));
    return must(store->may_be_used_for_research(patient));
  };
  EXPECT_TRUE(must(store->may_be_used_for_research(patient)));
  EXPECT_TRUE(say("research", "given"));
  EXPECT_TRUE(say("treatment", "refused"));
  EXPECT_FALSE(say("research", "withdrawn"));
  EXPECT_TRUE(say("research", "given"));
  EXPECT_EQ(must(consents(*access, "P-1")).size(), 4u);
  EXPECT_EQ(must(consents(*access, "P-1")).at(0).text, "SECRETFORM");
  EXPECT_EQ(must(consents(*access, "P-1")).at(0).recorded_by, "clinic passphrase");
  EXPECT_EQ(bytes_of(path + "-wal").find("SECRETFORM"), std::string::npos);
  for (Consent bad : {Consent{0, "2026-02-30", "research", "consent", "given", "", "", ""},
                      Consent{0, "2026-03-05", "fun", "consent", "given", "", "", ""},
                      Consent{0, "2026-03-05", "research", "a nod", "given", "", "", ""},
                      Consent{0, "2026-03-05", "research", "consent", "maybe", "", "", ""}})
    EXPECT_FALSE(add_consent(*access, "P-1", bad).ok());
}

}  // namespace
}  // namespace isograsp::storage::erasure_test
