// SPDX-License-Identifier: GPL-3.0-or-later
// Login, roles, PINs, delays, change of passphrase: what opens a protected database and what not.
#include "storage/access/access.hpp"

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/open_store.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::access_test {
namespace {
const Identity kPerson{"Vera Nováková", "1950-03-05", "+49 123\nBerlin"};

void execute(const std::string& path, const std::string& statement) {
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  sql << statement;
}

TEST_F(ProtectedClinic, OpensForPassphraseRecoveryKeyAndPasswordsOnly) {
  restart();
  EXPECT_FALSE(access->user());
  EXPECT_NE(refusal(access->log_in_with_passphrase(secret("the clinic's passphrasE"))), "");
  EXPECT_NE(refusal(access->log_in("Theo", secret("rita's password"))), "");
  EXPECT_NE(refusal(access->log_in("Nobody", secret("theo's password"))), "");
  EXPECT_FALSE(access->user()) << "a wrong password opened it";
  must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  EXPECT_EQ(access->user()->role, Role::administrator);
  restart();
  must(access->log_in_with_recovery_key(recovery_key));
  restart();
  as("Theo");
  EXPECT_EQ(access->user()->name, "Theo");
}

TEST_F(ProtectedClinic, IsClosedToStoresUntilSomebodyLogsIn) {
  restart();
  for (const OpenMode how : {OpenMode::create, OpenMode::existing, OpenMode::read_only}) {
    const auto store = open_store(path, how);
    ASSERT_FALSE(store.ok());
    EXPECT_NE(store.error().message().find("--passphrase-file"), std::string::npos);
  }
  EXPECT_FALSE(open_store_to_read(path).ok());
  as("Theo");
  must(opened(path)->add_patient("P-1"));
  access->log_out();
  EXPECT_FALSE(open_store(path, OpenMode::read_only).ok());
}

TEST_F(ProtectedClinic, AResearcherReadsRecordsButNeverWhoTheyAreOf) {
  as("Theo");
  {
    const auto store = opened(path);
    const RowId patient = must(store->add_patient("P-1")).id;
    must(store->set_profile(patient, {Side::left, {}, "", "lives in Berlin", "ride a bicycle"}));
    must(set_identity(*access, "P-1", kPerson));
  }
  restart();
  as("Rita");
  EXPECT_NE(refusal(read_identity(*access, "P-1")), "");
  EXPECT_NE(refusal(read_identity(*access, "P-1", "an emergency")), "");
  EXPECT_NE(refusal(all_identities(*access)), "");
  EXPECT_NE(refusal(set_identity(*access, "P-1", kPerson)), "");
  EXPECT_FALSE(open_store(path, OpenMode::existing).ok()) << "may write";
  const auto store = must(open_store_to_read(path));
  const auto patients = must(store->patients());
  ASSERT_EQ(patients.size(), 1u);
  EXPECT_EQ(must(store->profile(patients[0].id)),
            (PatientProfile{Side::left, {}, "", "[withheld]", "[withheld]"}));
  EXPECT_TRUE(must(store->check()).empty());
}

TEST_F(ProtectedClinic, ARoleChangedInTheFileOpensNothing) {
  restart();
  access.reset();
  execute(path, "UPDATE users SET role = 'administrator' WHERE name = 'Rita'");
  execute(path,
          "UPDATE key_slots SET wrapped = (SELECT wrapped FROM key_slots WHERE user_id = 2), "
          "salt = (SELECT salt FROM key_slots WHERE user_id = 2) WHERE user_id = 1");
  access = must(Access::open(path));
  EXPECT_NE(refusal(access->log_in("Rita", secret("rita's password"))), "");
  EXPECT_NE(refusal(access->log_in("Ada", secret("theo's password"))), "") << "a carried slot";
}

TEST_F(ProtectedClinic, TheDelayGrowsAndOutlivesTheProgram) {
  restart();
  const auto wrong = [&] { return refusal(access->log_in("Theo", secret("wrong password"))); };
  EXPECT_NE(wrong().find("try again"), std::string::npos);
  EXPECT_NE(wrong().find("try again"), std::string::npos);
  EXPECT_NE(wrong().find("wait 2 s"), std::string::npos);
  now_s += 1;
  restart();
  const std::string waits = refusal(access->log_in("Theo", secret("theo's password")));
  EXPECT_NE(
      waits.find("too many wrong passwords, or several people log in at this moment; wait 1 s"),
      std::string::npos)
      << waits;
  now_s += 1;
  EXPECT_NE(wrong().find("wait 4 s"), std::string::npos);
  as("Ada");  // nobody else has to wait
  now_s -= 1'000'000;
  EXPECT_NE(wrong().find("wait 4 s"), std::string::npos) << "a clock that was put back locks out";
  now_s += 2'000'000;
  as("Theo");
  EXPECT_NE(wrong().find("try again"), std::string::npos) << "the right one ends the count";
}

TEST(Delay, DoublesUpToFiveMinutes) {
  EXPECT_EQ(delay_after(0), 0);
  EXPECT_EQ(delay_after(2), 0);
  for (int n = 3; n <= 10; ++n) EXPECT_EQ(delay_after(n), 1 << (n - 2));
  EXPECT_EQ(delay_after(11), 300);
  EXPECT_EQ(delay_after(1'000'000), 300);
}

TEST(Lock, NeverStopsATrial) {
  const AccessPolicy policy;
  EXPECT_FALSE(is_lock_due(policy, 599.0, false));
  EXPECT_TRUE(is_lock_due(policy, 600.0, false));
  EXPECT_FALSE(is_lock_due(policy, 1e9, true));
}

TEST_F(ProtectedClinic, APinNamesThePersonWhereSomebodyHasOpenedTheDatabase) {
  as("Ada");
  must(set_own_pin(*access, secret("4711")));
  as("Theo");
  must(set_own_pin(*access, secret("2580")));
  EXPECT_NE(refusal(access->switch_user("Ada", secret("4711"))), "")
      << "a therapist's keys made an administrator";
  as("Ada");
  must(access->switch_user("Theo", secret("2580")));
  EXPECT_EQ(access->user()->name, "Theo");
  EXPECT_FALSE(access->allows(Right::manage));
  must(access->switch_user("Ada", secret("4711")));
  EXPECT_TRUE(access->allows(Right::manage));
  restart();
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))), "") << "a PIN opened the file";
  as("Rita");
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))), "");
}

TEST_F(ProtectedClinic, ThreeWrongPinsAskForThePassword) {
  as("Theo");
  must(set_own_pin(*access, secret("2580")));
  for (int i = 0; i < kMostWrongPins; ++i)
    EXPECT_NE(refusal(access->switch_user("Theo", secret("2581"))), "");
  EXPECT_NE(refusal(access->switch_user("Theo", secret("2580"))), "");
  as("Theo");
  must(access->switch_user("Theo", secret("2580")));
}

TEST_F(ProtectedClinic, PinsThatAreEasyToGuessAreRefused) {
  as("Theo");
  for (const char* pin : {"1111", "1234", "4321", "123", "12a4", "1234567890123"})
    EXPECT_NE(refusal(set_own_pin(*access, secret(pin))), "") << pin;
}

TEST_F(ProtectedClinic, ALockClosesTextsAndIdentitiesAndKeepsTheRecordingGoing) {
  as("Theo");
  must(set_own_pin(*access, secret("2580")));
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  must(store->set_profile(patient, {{}, {}, "", "a note", ""}));
  must(set_identity(*access, "P-1", kPerson));
  const RowId session = must(store->begin_session(example_session(patient)));
  TrialRecord trial = example_trial(session);
  trial.id = must(store->begin_trial(trial));
  access->lock();
  EXPECT_TRUE(access->is_locked());
  EXPECT_FALSE(store->profile(patient).ok());
  EXPECT_FALSE(read_identity(*access, "P-1").ok());
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  must(store->add_event(session, {trial.id, 1.0, "note", "helped him"}));
  trial.status = TrialStatus::completed;
  must(store->end_trial(trial, {}));
  must(store->end_session(session));
  must(access->switch_user("Theo", secret("2580")));
  EXPECT_EQ(must(store->profile(patient)).notes, "a note");
  EXPECT_EQ(must(store->events(session)).at(0).text, "helped him");
}

TEST_F(ProtectedClinic, AResearcherWhoTakesOverEndsTheRecordingAndWritesNothingElse) {
  as("Theo");
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  const RowId mark = must(store->add_treatment_mark(patient, {0, "2026-03-01", "drug", ""}));
  const RowId session = must(store->begin_session(example_session(patient)));
  TrialRecord trial = example_trial(session);
  trial.id = must(store->begin_trial(trial));
  as("Rita");
  must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
  must(store->add_event(session, {trial.id, 1.0, "stop", "key"}));
  trial.status = TrialStatus::completed;
  must(store->end_trial(trial, {}));
  const std::vector<SessionAnswer> answers{{"posture", "seat", "chair"}};
  for (const std::string& why :
       {refusal(store->add_patient("P-2")), refusal(store->remove_patient(patient)),
        refusal(store->remove_treatment_mark(mark)), refusal(store->set_profile(patient, {})),
        refusal(store->mark_helped(trial.id, true)),
        refusal(store->begin_session(example_session(patient))),
        refusal(store->add_answers(session, answers)),
        refusal(store->add_preparation(example_preparation(session))),
        refusal(store->begin_trial(example_trial(session, 2))),
        refusal(store->add_rating({0, session, trial.id, 2.0, "2026-03-01T10:00:00Z", 3, 1})),
        refusal(store->correct_rating({1, session, trial.id, 2.0, "", 3, 1}))})
    EXPECT_NE(why.find("the role researcher may not change records"), std::string::npos) << why;
  must(store->end_session(session));
  as("Ada");
  const auto refused = must(read_audit(*access, {"change profile", "P-1"})).back();
  EXPECT_EQ(refused.actor + " " + refused.result, "Rita refused");
  EXPECT_EQ(must(store->treatment_marks(patient)).size(), 1u);
}

TEST_F(ProtectedClinic, ANewPassphraseWrapsTheSameKeys) {
  must(opened(path)->add_patient("P-1"));
  must(set_identity(*access, "P-1", kPerson));
  must(change_passphrase(*access, secret("another passphrase"), kCheapKeyCost));
  const Secret new_key = must(new_recovery_key(*access));
  must(accept_recovery_key(*access, new_key));
  restart();
  EXPECT_NE(refusal(access->log_in_with_passphrase(secret("the clinic's passphrase"))), "");
  EXPECT_NE(refusal(access->log_in_with_recovery_key(recovery_key)), "");
  must(access->log_in_with_recovery_key(new_key));
  must(access->log_in_with_passphrase(secret("another passphrase")));
  EXPECT_EQ(must(read_identity(*access, "P-1")), kPerson);
  as("Theo");
  EXPECT_EQ(must(read_identity(*access, "P-1")), kPerson);
}

TEST_F(ProtectedClinic, PasswordsAreChangedByTheirOwnerOrReset) {
  as("Theo");
  EXPECT_NE(refusal(change_own_password(*access, secret("wrong one!"), secret("new password"),
                                        kCheapKeyCost)),
            "");
  must(change_own_password(*access, secret("theo's password"), secret("new password"),
                           kCheapKeyCost));
  EXPECT_NE(refusal(reset_password(*access, "Ada", secret("taken over"), kCheapKeyCost)), "");
  restart();
  must(access->log_in("theo", secret("new password")));  // capitals of names do not matter
  as("Ada");
  must(reset_password(*access, "Theo", secret("theo's password"), kCheapKeyCost));
  as("Theo");
}

TEST_F(ProtectedClinic, ARemovedAccountIsGoneAndItsNameNotGivenAgain) {
  must(remove_user(*access, "Theo"));
  EXPECT_EQ(must(access->users()).size(), 2u);
  EXPECT_NE(
      refusal(add_user(*access, "theo", Role::therapist, secret("theo's password"), kCheapKeyCost)),
      "");
  EXPECT_NE(refusal(access->log_in("Theo", secret("theo's password"))), "");
}

TEST_F(ProtectedClinic, IdentityAndFreeTextStandNowhereInTheFile) {
  as("Theo");
  {
    const auto store = opened(path);
    const RowId patient = must(store->add_patient("P-1")).id;
    must(set_identity(*access, "P-1", kPerson));
    must(store->set_profile(patient, {{}, {}, "", "SECRETNOTE", "SECRETGOAL"}));
    must(store->add_treatment_mark(patient, {0, "2026-03-01", "drug", "SECRETMARK"}));
    must(store->add_clinical_score(patient, {0, "2026-03-01", "ARAT", 31.0, "SECRETSCORE"}));
    must(store->add_primary_measure(patient,
                                    {0, "Sine", Hand::left, "rmse", "force", "", "SECRETCHOOSER"}));
    must(store->add_stable_period(
        patient, {0, "2026-01-01", "2026-01-31", "", "SECRETJUDGE", "SECRETPERIOD"}));
    const RowId session = must(store->begin_session(example_session(patient)));
    must(store->add_event(session, {std::nullopt, 1.0, "note", "SECRETEVENT"}));
    EXPECT_EQ(must(store->treatment_marks(patient)).at(0).text, "SECRETMARK");
    EXPECT_EQ(must(store->clinical_scores(patient)).at(0).text, "SECRETSCORE");
    EXPECT_EQ(must(store->primary_measures(patient)).at(0).chosen_by, "SECRETCHOOSER");
    EXPECT_EQ(must(store->stable_periods(patient)).at(0).judged_by, "SECRETJUDGE");
    EXPECT_EQ(must(store->stable_periods(patient)).at(0).text, "SECRETPERIOD");
    EXPECT_EQ(must(store->events(session)).at(0).text, "SECRETEVENT");
    EXPECT_TRUE(must(store->check()).empty());
  }
  for (const std::string& name : test::every(folder.listing())) {
    const std::string bytes = bytes_of(folder.file(name));
    // Short words come about in base64 by chance.
    for (const std::string& text : {std::string("SECRET"), kPerson.name, kPerson.birth_date,
                                    std::string("Berlin"), std::string("passphrase ")})
      EXPECT_EQ(bytes.find(text), std::string::npos) << text << " in " << name;
  }
}

TEST_F(ProtectedClinic, ATextOrIdentityCarriedToAnotherPersonIsNoticed) {
  as("Theo");
  {
    const auto store = opened(path);
    for (const char* code : {"P-1", "P-2"}) {
      const RowId patient = must(store->add_patient(code)).id;
      must(store->set_profile(patient, {{}, {}, "", std::string("note of ") + code, ""}));
      must(set_identity(*access, code, {std::string("Name of ") + code, "", ""}));
    }
  }
  execute(path,
          "UPDATE patient_profiles SET notes = "
          "(SELECT notes FROM patient_profiles WHERE patient_id = 1)");
  execute(path,
          "UPDATE identities SET sealed = "
          "(SELECT sealed FROM identities WHERE patient_id = 1)");
  const auto store = opened(path);
  EXPECT_EQ(must(store->profile(1)).notes, "note of P-1");
  EXPECT_NE(refusal(store->profile(2)).find("was changed or is damaged"), std::string::npos);
  EXPECT_EQ(must(read_identity(*access, "P-1"))->name, "Name of P-1");
  EXPECT_NE(refusal(read_identity(*access, "P-2")).find("was changed or is damaged"),
            std::string::npos);
}

TEST_F(ProtectedClinic, ABackupIsMadeBehindTheLock) {
  {
    const auto store = opened(path);
    const RowId patient = must(store->add_patient("P-1")).id;
    must(store->set_profile(patient, {{}, {}, "", "a note", ""}));
    must(store->add_treatment_mark(patient, {0, "2026-03-01", "drug", "a mark"}));
  }
  access->lock();
  const std::string copy = folder.file("copy.db");
  must(must(open_store(path, OpenMode::read_only))->backup(copy));
  as("Ada");
  EXPECT_EQ(must(opened(copy, OpenMode::read_only)->profile(1)).notes, "a note");
}

TEST_F(ProtectedClinic, ACheckNamesATextThatCannotBeOpenedAndGoesOn) {
  {
    const auto store = opened(path);
    for (const char* code : {"P-1", "P-2"})
      must(store->set_profile(must(store->add_patient(code)).id, {{}, {}, "", "a note", ""}));
    must(store->add_clinical_score(2, {0, "2026-03-01", "ARAT", 31.0, "a score"}));
  }
  execute(path, "UPDATE patient_profiles SET notes = substr(notes, 1, 40) WHERE patient_id = 1");
  execute(path, "UPDATE clinical_scores SET text = 'sealed:1:'");
  const auto problems = must(opened(path)->check());
  ASSERT_EQ(problems.size(), 4u) << "and two rows are not what was written";
  EXPECT_NE(english(problems[0]).find("patient_profiles.notes of P-1"), std::string::npos)
      << english(problems[0]);
  EXPECT_NE(english(problems[1]).find("clinical_scores.text of P-2"), std::string::npos)
      << english(problems[1]);
}

TEST_F(ProtectedClinic, ABackupOpensWithTheSamePassphraseAndHoldsEverything) {
  must(opened(path)->add_patient("P-1"));
  must(set_identity(*access, "P-1", kPerson));
  const std::string copy = folder.file("copy.db");
  must(opened(path)->backup(copy));
  access.reset();
  EXPECT_FALSE(open_store(copy, OpenMode::read_only).ok());
  access = must(Access::open(copy));
  must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  EXPECT_EQ(must(read_identity(*access, "P-1")), kPerson);
  EXPECT_TRUE(must(check_audit(*access)).empty());
}

TEST(Unprotected, AsksForNoLoginAndStoresNoIdentity) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  const auto store = opened(path);
  const RowId patient = must(store->add_patient("P-1")).id;
  must(store->set_profile(patient, {{}, {}, "", "a note", ""}));
  const auto access = must(Access::open(path));
  EXPECT_FALSE(access->is_protected());
  EXPECT_FALSE(is_protected_database(path));
  EXPECT_NE(refusal(set_identity(*access, "P-1", kPerson)).find("db protect FILE"),
            std::string::npos);
  EXPECT_NE(refusal(access->log_in_with_passphrase(secret("anything at all"))), "");
  EXPECT_NE(refusal(add_user(*access, "Ada", Role::therapist, secret("ada's password"))), "");
  EXPECT_EQ(folder.listing(),
            (std::vector<std::string>{"clinic.db", "clinic.db-shm", "clinic.db-wal"}));
}

TEST(Unprotected, ThatAnotherProgramHasLockedIsNoFileThatIsOnlyRead) {
  const TemporaryFolder folder;
  const std::string path = folder.file("clinic.db");
  opened(path);
  soci::session other(soci::sqlite3, "db=\"" + path + "\"");
  std::string mode;
  int count = 0;
  other << "PRAGMA journal_mode=DELETE", soci::into(mode);
  other << "BEGIN";
  other << "SELECT count(*) FROM patients", soci::into(count);
  EXPECT_NE(refusal(Access::open(path)).find("locked by another program"), std::string::npos);
  other << "COMMIT";
  EXPECT_TRUE(must(Access::open(path))->can_log());
}

TEST(Create, RefusesAShortPassphraseAndAnExistingFileAndLeavesNothing) {
  const TemporaryFolder folder;
  EXPECT_FALSE(Access::create(folder.file("a.db"), secret("seven77"), &kCheapKeyCost).ok());
  EXPECT_TRUE(folder.listing().empty());
  std::ofstream(folder.file("b.db")) << "somebody's";
  EXPECT_FALSE(Access::create(folder.file("b.db"), secret("long enough"), &kCheapKeyCost).ok());
  EXPECT_EQ(bytes_of(folder.file("b.db")), "somebody's");
  EXPECT_FALSE(
      Access::create(folder.file("none/c.db"), secret("long enough"), &kCheapKeyCost).ok());
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"b.db"});
}

}  // namespace
}  // namespace isograsp::storage::access_test
