// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of merging: what was there stays, twice is once, either way round gives the same.
#include "storage/care/merge.hpp"

#include <map>
#include <set>

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/care/migration.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/erasure.hpp"
#include "tests/storage/examples.hpp"
#include "tests/storage/sealed_write.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::merge_test {
namespace {

/// Two sessions of two trials with everything that a file can hold of them.
void add_sessions(SessionStore& store, RowId patient, unsigned seed) {
  for (int s = 0; s < 2; ++s) {
    SessionRecord record = example_session(patient);
    record.started_utc =
        "2026-03-0" + std::to_string(1 + s) + "T09:30:" + std::to_string(10 + seed) + "Z";
    const RowId session = must(store.begin_session(
        record, std::vector<SessionAnswer>{{"screening", "seed", std::to_string(seed)}}));
    PreparationRecord zero = example_preparation(session, seed);
    zero.references = {{"change_N", 0.1 * seed}};
    const RowId zero_id = must(store.add_preparation(zero));
    for (int t = 1; t <= 2; ++t) {
      TrialRecord trial = example_trial(session, t);
      trial.preparations = {zero_id};
      trial.id = must(store.begin_trial(trial));
      must(store.append_blocks(trial.id, 0, example_rows(trial, 50, 100 * seed + 10 * t + s)));
      trial.status = TrialStatus::completed;
      Measure measure;
      measure.name = "rmse";
      measure.value = seed + 0.5 * t;
      Measure none;
      none.name = "lag";
      none.reason = "too short";
      must(store.end_trial(trial, std::vector{measure, none}));
      // The same twice: both are kept.
      for (int i = 0; i < 2; ++i) must(store.add_event(session, {trial.id, 1.0, "note", "twice"}));
      must(store.add_rating({0, session, trial.id, 2.0, "2026-03-01T10:00:00Z", 3, t}));
    }
    must(store.end_session(session, "2026-03-09T10:00:00Z"));
  }
}

void make_station(const std::string& path, const std::string& code, unsigned seed) {
  const auto store = opened(path);
  const RowId patient =
      must(store->add_patient(code, "2026-01-0" + std::to_string(1 + seed) + "T00:00:00Z")).id;
  must(store->set_profile(patient, {Side::left, Hand::right, "2025-11-01", "notes", "goals"}));
  must(store->add_treatment_mark(patient, {0, "2026-02-01", "drug", std::to_string(seed)}));
  must(store->add_clinical_score(patient, {0, "2026-02-02", "ARAT", seed + 0.5, ""}));
  must(store->add_primary_measure(
      patient, {0, "Grip force, sine", Hand::left, "rmse" + std::to_string(seed), "force",
                "2026-02-03T00:00:00Z", "Therapist 7"}));
  must(store->add_stable_period(patient, {0, "2026-0" + std::to_string(1 + seed) + "-01",
                                          "2026-0" + std::to_string(1 + seed) + "-20",
                                          "2026-05-01T00:00:00Z", "Therapist 7", ""}));
  add_sessions(*store, patient, seed);
}

/// All content of a file without the numbers of rows, sorted: a set.
std::multiset<std::string> content_of(const std::string& path) {
  std::multiset<std::string> all;
  const auto held = opened(path, OpenMode::read_only);
  SessionStore& store = *held;
  EXPECT_EQ(must(store.check()), std::vector<Text>{});
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  for (const auto& stone : must(tombstones(*must(Access::open(path)))))
    all.insert(stone.code + " erased " + stone.erased_utc + stone.erased_by);
  for (const auto& patient : test::every(must(store.patients()))) {
    std::set<std::string> uuids{patient.uuid};
    std::string uuid;
    soci::statement select =
        (sql.prepare << "SELECT uuid FROM patient_aliases WHERE patient_id = :id",
         soci::use(patient.id), soci::into(uuid));
    select.execute();
    while (select.fetch()) uuids.insert(uuid);
    std::string names = patient.uuid + " of";
    for (const auto& one : uuids) names += " " + one;
    const std::string who = patient.code + " ";
    all.insert(who + patient.created_utc + names);
    const auto profile = must(store.profile(patient.id));
    all.insert(who + "profile " + profile.onset_date + profile.notes + profile.goals);
    for (const auto& one : must(store.treatment_marks(patient.id)))
      all.insert(who + one.on_date + one.kind + one.text);
    for (const auto& one : must(store.clinical_scores(patient.id)))
      all.insert(who + one.on_date + one.scale + std::to_string(one.value));
    for (const auto& one : must(store.primary_measures(patient.id)))
      all.insert(who + one.task_name + one.measure + one.chosen_utc);
    for (const auto& one : must(store.stable_periods(patient.id)))
      all.insert(who + one.from_date + one.until_date + one.judged_by);
    for (const auto& session : must(store.sessions(patient.id))) {
      const std::string of = who + session.uuid + " ";
      all.insert(of + session.started_utc + session.ended_utc + session.device_uri);
      for (const auto& one : must(store.answers(session.id)))
        all.insert(of + one.topic + one.item + one.value);
      for (const auto& one : session.sensors) all.insert(of + one.name + one.serial_number);
      for (const auto& [name, value] : session.references)
        all.insert(of + name + std::to_string(value));
      for (const auto& one : must(store.preparations(session.id))) {
        all.insert(of + one.kind + std::to_string(one.mean[0]));
        for (const auto& [name, value] : one.references)
          all.insert(of + one.kind + name + std::to_string(value));
      }
      std::map<RowId, std::string> uuid_of_trial{{0, "none"}};
      const auto trials = must(store.trials(session.id));
      for (const auto& trial : trials) uuid_of_trial[trial.id] = trial.uuid;
      for (const auto& one : must(store.events(session.id)))
        all.insert(of + one.kind + one.text + uuid_of_trial.at(one.trial_id.value_or(0)));
      for (const auto& one : must(store.ratings(session.id)))
        all.insert(of + std::to_string(one.pain) + uuid_of_trial.at(one.trial_id.value_or(0)));
      for (const auto& trial : test::every(trials)) {
        EXPECT_EQ(trial.preparations, std::vector{must(store.preparations(session.id)).front().id});
        for (const auto& [name, value] : trial.references)
          all.insert(of + trial.uuid + name + std::to_string(value));
        all.insert(of + trial.uuid + std::to_string(trial.number) + trial.signals_hash);
        EXPECT_EQ(must(store.signals(trial)).rows(), 50u);
        for (const auto& one : must(store.measures(trial.id)))
          all.insert(of + trial.uuid + one.name + one.reason +
                     (one.value ? std::to_string(*one.value) : ""));
      }
    }
  }
  return all;
}

struct Merge : testing::Test {
  TemporaryFolder folder;
  std::string a = folder.file("a.db");
  std::string b = folder.file("b.db");

  [[nodiscard]] std::string copy(const std::string& of, const std::string& name) const {
    const std::string to = folder.file(name);
    must(opened(of, OpenMode::read_only)->backup(to));
    return to;
  }
  static void execute(const std::string& path, const std::string& statement) {
    write_sealed(path, statement);
  }
  /// Both ways round give the same, and again changes nothing. That content.
  std::multiset<std::string> expect_laws(const std::vector<std::string>& same = {}) {
    const std::string ab = copy(a, "ab.db");
    const std::string ba = copy(b, "ba.db");
    const auto other = content_of(b);
    const auto report = must(merge_databases(ab, b, same));
    EXPECT_EQ(report.conflicts, std::vector<Text>{});
    EXPECT_EQ(must(merge_databases(ba, a, same)).conflicts, std::vector<Text>{});
    const auto whole = content_of(ab);
    EXPECT_EQ(content_of(ba), whole);
    EXPECT_EQ(content_of(b), other) << "the other file stays as it was";
    for (const auto& [into, from] : {std::pair{ab, b}, {ab, a}, {ba, ab}, {ab, ba}}) {
      const auto again = must(merge_databases(into, from));  // who is who is known by now
      EXPECT_EQ(again.conflicts, std::vector<Text>{});
      EXPECT_EQ(again.patients_added + again.sessions_added + again.trials_added, 0);
      EXPECT_EQ(content_of(into), whole);
    }
    return whole;
  }
};

TEST_F(Merge, OfScratchFilesGivesTheSameBytesEachTime) {
  const auto whole = [&](const std::string& name) {
    const std::string into = folder.file(name);
    opened(into, OpenMode::scratch);
    for (const unsigned seed : {1U, 2U}) {
      const std::string part = folder.file(name + std::to_string(seed));
      add_sessions(*opened(part, OpenMode::scratch),
                   must(opened(part, OpenMode::scratch)
                            ->add_patient("A-" + std::to_string(seed), "2026-01-01T00:00:00Z"))
                       .id,
                   seed);
      EXPECT_EQ(must(merge_databases(into, part, {}, OpenMode::scratch)).patients_added, 1);
    }
    return bytes_of(into);
  };
  EXPECT_EQ(whole("one.db"), whole("two.db"));
}

TEST_F(Merge, OfDifferentPatientsHoldsBoth) {
  make_station(a, "A-1", 1);
  make_station(b, "B-1", 2);
  auto both = content_of(a);
  for (const auto& line : content_of(b)) both.insert(line);
  EXPECT_EQ(expect_laws(), both);
}

TEST_F(Merge, OfOnePatientThatWasEnteredTwiceJoinsThemOnlyWhenToldSo) {
  make_station(a, "P-1", 1);
  make_station(b, "p-1", 2);
  const auto before = content_of(a);
  const auto refused = must(merge_databases(a, b));
  ASSERT_EQ(refused.conflicts.size(), 1u);
  EXPECT_NE(english(refused.conflicts[0]).find("--same-patient p-1"), std::string::npos);
  EXPECT_EQ(content_of(a), before);
  expect_laws({"P-1"});
  const auto store = opened(folder.file("ab.db"));
  ASSERT_EQ(must(store->patients()).size(), 1u);
  EXPECT_EQ(must(store->patients())[0].created_utc, "2026-01-02T00:00:00Z");
  const auto sessions = must(store->sessions(must(store->patients())[0].id));
  ASSERT_EQ(sessions.size(), 4u);
  EXPECT_TRUE(std::is_sorted(sessions.begin(), sessions.end(), [](const auto& x, const auto& y) {
    return x.started_utc < y.started_utc;
  }));
}

TEST_F(Merge, OfACopyThatWentOnAddsWhatIsNew) {
  make_station(a, "P-1", 1);
  b = copy(a, "b.db");
  {
    const auto store = opened(a);
    add_sessions(*store, must(store->patients())[0].id, 3);
    must(store->add_patient("Q-1"));
  }
  {
    const auto store = opened(b);
    add_sessions(*store, must(store->patients())[0].id, 4);
    must(store->add_treatment_mark(1, {0, "2026-02-09", "therapy", "at b"}));
  }
  const auto whole = expect_laws();
  for (const auto& station : {content_of(a), content_of(b)})
    EXPECT_TRUE(std::includes(whole.begin(), whole.end(), station.begin(), station.end()));
  const auto report = must(merge_databases(a, b));
  EXPECT_EQ(report.patients_added, 0);
  EXPECT_EQ(report.sessions_added, 2);
  EXPECT_EQ(report.trials_added, 4);
  EXPECT_EQ(report.trials_present, 4);
}

TEST_F(Merge, OfDifferentContentUnderOneUuidIsReportedAndNothingIsChanged) {
  struct Change {
    const char* statement;
    const char* reported;
  };
  make_station(a, "P-1", 1);
  const std::string sound = copy(a, "sound.db");
  const auto before = content_of(a);
  int number = 0;
  for (const Change& change :
       {Change{"UPDATE trials SET helped = 1 WHERE id = 2", "trial 2 of the session of P-1"},
        {"UPDATE trials SET signals_blake2b = zeroblob(32) WHERE id = 3", "(signals_blake2b)"},
        {"UPDATE sessions SET hand = 'right' WHERE id = 1", "(hand)"},
        {"UPDATE patient_profiles SET notes = 'other'", "the profile of P-1"},
        {"UPDATE session_sensors SET serial_number = 'X' WHERE session_id = 2 AND position = 3",
         "(session_sensors)"},
        {"DELETE FROM session_references WHERE session_id = 1", "(session_references)"},
        {"UPDATE trial_references SET value = 9.5 WHERE trial_id = 2 AND name = 'maximum_force_N'",
         "trial 2 of the session of P-1"},
        {"INSERT INTO trial_references VALUES (3, 'more', 0.5)", "(trial_references)"},
        {"DELETE FROM trial_preparations WHERE trial_id = 4", "(trial_preparations)"},
        {"UPDATE measures SET value = value + 1 WHERE trial_id = 1", "with different measures"},
        {"DELETE FROM measures WHERE trial_id = 4", "with different measures"},
        {"UPDATE patients SET code = 'P-2'", "their codes must agree"},
        {"UPDATE primary_measures SET chosen_by = 'X'", "was chosen in both files"},
        {"UPDATE stable_periods SET until_date = '2026-02-19'", "overlap on 2026-02-01"}}) {
    b = copy(sound, "b" + std::to_string(++number) + ".db");
    execute(b, change.statement);
    execute(b,
            "INSERT INTO patients (code, created_utc, uuid, salt) VALUES ('N-1', '', "
            "'00000000-0000-4000-8000-000000000000', zeroblob(16))");
    const auto report = must(merge_databases(a, b));
    ASSERT_FALSE(report.conflicts.empty()) << change.statement;
    EXPECT_NE(english(report.conflicts[0]).find(change.reported), std::string::npos)
        << english(report.conflicts[0]);
    EXPECT_EQ(content_of(a), before) << change.statement;
  }
}

/// A station is copied between two trials of a session that then goes on.
TEST_F(Merge, OfASessionThatWasStillOpenTakesItsEnd) {
  {
    const auto store = opened(a);
    const RowId session =
        must(store->begin_session(example_session(must(store->add_patient("P-1")).id)));
    PreparationRecord zero = example_preparation(session);
    const RowId zero_id = must(store->add_preparation(zero));
    const auto record = [&](int number) {
      TrialRecord trial = example_trial(session, number);
      trial.preparations = {zero_id};
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 50, 7)));
      trial.status = TrialStatus::completed;
      must(store->end_trial(trial, {}));
    };
    record(1);
    b = copy(a, "b.db");
    record(2);
    zero.references = {{"drift_N", 0.5}};
    zero.drifted = true;
    must(store->add_preparation(zero));
    must(store->end_session(session, "2026-03-01T10:00:00Z"));
  }
  expect_laws();
  for (const char* merged : {"ab.db", "ba.db"}) {
    const auto store = opened(folder.file(merged));
    EXPECT_EQ(must(store->sessions(1)).at(0).ended_utc, "2026-03-01T10:00:00Z") << merged;
    EXPECT_EQ(must(store->trials(1)).at(0).drift.at("drift_N"), 0.5) << merged;
    EXPECT_TRUE(must(store->trials(1)).at(0).drifted) << merged;
  }
  execute(b, "UPDATE sessions SET ended_utc = '2026-03-01T11:00:00Z'");
  const auto differ = must(merge_databases(a, b));
  ASSERT_FALSE(differ.conflicts.empty());
  EXPECT_NE(english(differ.conflicts[0]).find("(ended_utc)"), std::string::npos);
}

TEST_F(Merge, OfATrialThatIsPackedInOneFileOnlyComparesItsValues) {
  make_station(a, "P-1", 1);
  {
    const auto store = opened(a);
    TrialRecord trial = example_trial(1, 9);
    trial.id = must(store->begin_trial(trial));
    for (int s = 0; s < 12; ++s)
      must(store->append_blocks(trial.id, s, example_rows(trial, 100, static_cast<unsigned>(s))));
    // As if the power had failed before the signals were packed.
    execute(a, "UPDATE trials SET status = 'completed', sample_count = 1200 WHERE number = 9");
  }
  b = copy(a, "b.db");
  EXPECT_EQ(must(migrate_database(b)).packed, 1);
  for (const auto& [into, from] : {std::pair{a, b}, {b, a}}) {
    const auto report = must(merge_databases(into, from));
    EXPECT_EQ(report.conflicts, std::vector<Text>{});
    EXPECT_EQ(report.trials_present, 5);
  }
  execute(b, "UPDATE trials SET signals_blake2b = zeroblob(32) WHERE number = 9");
  for (const auto& [into, from] : {std::pair{a, b}, {b, a}}) {
    const auto report = must(merge_databases(into, from));
    ASSERT_EQ(report.conflicts.size(), 1u);
    EXPECT_NE(english(report.conflicts[0]).find("trial 9"), std::string::npos);
  }
}

TEST_F(Merge, TakesInNothingThatAnotherProgramHasChanged) {
  make_station(a, "A-1", 1);
  make_station(b, "B-1", 2);
  for (const std::string& changed : {a, b}) {
    const std::string sound = copy(changed, "sound.db");
    soci::session(soci::sqlite3, "db=\"" + changed + "\"")
        << "UPDATE measures SET value = 0.5 WHERE id = 1";
    const auto refused = merge_databases(a, b);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().file, changed);
    EXPECT_NE(refused.error().message().find("measures: row 1 is not what isograsp wrote"),
              std::string::npos)
        << refused.error().message();
    std::filesystem::copy_file(sound, changed, std::filesystem::copy_options::overwrite_existing);
    std::filesystem::remove(sound);
  }
}

/// At another station the person was erased: gone in both files afterwards, or a conflict.
TEST_F(Merge, NeverBringsBackWhoWasErased) {
  make_station(a, "A-1", 1);
  make_station(b, "B-1", 2);
  execute(a,
          "INSERT INTO tombstones (code, erased_utc, erased_by) VALUES "
          "('E-1', '2026-01-02T00:00:00Z', 'Ada'), ('E-2', '2026-01-01T00:00:00Z', 'Ada')");
  execute(b,
          "INSERT INTO tombstones (code, erased_utc, erased_by) VALUES "
          "('e-1', '2026-01-01T00:00:00Z', 'Bob'), ('E-3', '2026-01-01T00:00:00Z', 'Bob')");
  const auto whole = expect_laws();
  EXPECT_TRUE(whole.contains("e-1 erased 2026-01-01T00:00:00ZBob")) << "the first time counts";
  EXPECT_TRUE(whole.contains("E-2 erased 2026-01-01T00:00:00ZAda"));
  EXPECT_TRUE(whole.contains("E-3 erased 2026-01-01T00:00:00ZBob"));
  EXPECT_FALSE(opened(folder.file("ab.db"))->add_patient("E-3").ok());
  execute(b,
          "INSERT INTO tombstones (code, erased_utc, erased_by) VALUES "
          "('a-1', '2026-01-01T00:00:00Z', 'Bob')");
  const auto before = content_of(a);
  const auto into = must(merge_databases(a, b));
  ASSERT_EQ(into.conflicts.size(), 1u);
  EXPECT_NE(english(into.conflicts[0]).find("patient A-1 was erased in the other file"),
            std::string::npos);
  EXPECT_EQ(content_of(a), before);
  const auto from = must(merge_databases(b, a));
  ASSERT_EQ(from.conflicts.size(), 1u);
  EXPECT_NE(english(from.conflicts[0]).find("patient A-1 was erased here"), std::string::npos);
}

/// Each station has asked; which file is taken into which does not matter.
TEST_F(Merge, TheLastWordOnAConsentIsTheOneThatWasRecordedLast) {
  make_station(a, "P-1", 1);
  b = copy(a, "b.db");
  const auto say = [](const std::string& path, const std::string& state, const std::string& at) {
    must(add_consent(*must(Access::open(path)), "P-1",
                     {0, "2026-03-05", "research", "consent", state, "", "", ""}));
    execute(path, "UPDATE consents SET recorded_utc = '" + at + "' WHERE id = 1");
  };
  say(a, "withdrawn", "2026-03-06T10:00:00Z");
  say(b, "given", "2026-03-05T10:00:00Z");
  const auto released = [](const std::string& path) {
    return must(opened(path)->may_be_used_for_research(1));
  };
  EXPECT_TRUE(released(b));
  expect_laws();
  for (const char* merged : {"ab.db", "ba.db"})
    EXPECT_FALSE(released(folder.file(merged))) << merged;
}

TEST_F(Merge, IsRefusedWithAFileThatCannotBeMerged) {
  make_station(a, "P-1", 1);
  const auto before = content_of(a);
  EXPECT_FALSE(merge_databases(a, a).ok()) << "with itself";
  EXPECT_FALSE(merge_databases(a, folder.file("absent.db")).ok());
  std::filesystem::copy_file(std::string(ISOGRASP_SOURCE_DIR) + "/tests/data/format_5.db", b);
  const auto old = merge_databases(a, b);
  ASSERT_FALSE(old.ok());
  EXPECT_NE(old.error().message().find("isograsp db migrate"), std::string::npos);
  const std::string c = folder.file("c.db");
  make_station(c, "C-1", 2);
  const std::vector<std::string> wrong{"C-9"};
  EXPECT_FALSE(merge_databases(a, c, wrong).ok());
  const auto recording = opened(c);
  TrialRecord trial = example_trial(1, 9);
  trial.id = must(recording->begin_trial(trial));
  const auto running = merge_databases(a, c);
  ASSERT_FALSE(running.ok());
  EXPECT_NE(running.error().message().find("is being recorded"), std::string::npos);
  EXPECT_EQ(content_of(a), before);
}

}  // namespace
}  // namespace isograsp::storage::merge_test
