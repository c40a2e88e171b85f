// SPDX-License-Identifier: GPL-3.0-or-later
// A database that was made without protection gets it: nothing of its plain text stays.
#include "storage/access/protection.hpp"

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "storage/access/audit_chain.hpp"
#include "storage/access/open_store.hpp"
#include "storage/care/merge.hpp"
#include "storage/person/consent.hpp"
#include "storage/person/identity.hpp"
#include "tests/storage/protected_clinic.hpp"
#include "tests/support/every.hpp"

namespace isograsp::storage::protection_test {
namespace {

/// Free text in every column that can hold it, of two people; some of it removed again.
struct PlainClinic : testing::Test {
  TemporaryFolder folder;
  std::string path = folder.file("clinic.db");

  PlainClinic() {
    const auto store = opened(path);
    for (const char* code : {"P-1", "P-2"}) {
      const RowId patient = must(store->add_patient(code)).id;
      must(store->set_profile(patient, {Side::left, {}, "", "SECRETNOTE", "SECRETGOAL"}));
      must(store->add_treatment_mark(patient, {0, "2026-03-01", "drug", "SECRETMARK"}));
      must(store->remove_treatment_mark(
          must(store->add_treatment_mark(patient, {0, "2026-03-02", "drug", "SECRETGONE"}))));
      must(store->add_clinical_score(patient, {0, "2026-03-01", "ARAT", 31.0, "SECRETSCORE"}));
      must(store->add_primary_measure(
          patient, {0, "Sine", Hand::left, "rmse", "force", "", "SECRETCHOOSER"}));
      must(store->add_stable_period(
          patient, {0, "2026-01-01", "2026-01-31", "", "SECRETJUDGE", "SECRETPERIOD"}));
      const RowId session = must(store->begin_session(example_session(patient)));
      must(store->add_event(session, {std::nullopt, 1.0, "note", "SECRETEVENT"}));
      must(store->add_event(session, {std::nullopt, 2.0, "pause", "key"}));
      TrialRecord trial = example_trial(session);
      trial.id = must(store->begin_trial(trial));
      must(store->append_blocks(trial.id, 0, example_rows(trial, 100, 1)));
      trial.status = TrialStatus::completed;
      must(store->end_trial(trial, {}));
      must(add_consent(*must(Access::open(path)), code,
                       {0, "2026-03-05", "research", "consent", "given", "SECRETFORM", "", ""}));
    }
  }
  [[nodiscard]] Result<Protection> protect(const char* passphrase = "the clinic's passphrase") {
    return protect_database(path, secret(passphrase), &kCheapKeyCost);
  }
  /// In the database and everything beside it but the plain copy.
  [[nodiscard]] std::vector<std::string> files_with(const std::string& text) const {
    std::vector<std::string> found;
    for (const std::string& name : folder.listing())
      if (name != "clinic.db.before-protection" &&
          bytes_of(folder.file(name)).find(text) != std::string::npos)
        found.push_back(name);
    return found;
  }
};

TEST_F(PlainClinic, ProtectedLaterHoldsNoByteOfItsPlainTextAndLosesNone) {
  ASSERT_FALSE(files_with("SECRET").empty());
  const auto done = must(protect());
  EXPECT_FALSE(done.not_swept);
  EXPECT_EQ(files_with("SECRET"), std::vector<std::string>{});
  EXPECT_TRUE(is_protected_database(path));
  const auto store = opened(path);
  EXPECT_EQ(must(store->check()), std::vector<Text>{});
  for (const PatientRecord& patient : test::every(must(store->patients()))) {
    const PatientProfile profile = must(store->profile(patient.id));
    EXPECT_EQ(profile.notes + profile.goals, "SECRETNOTESECRETGOAL");
    ASSERT_EQ(must(store->treatment_marks(patient.id)).size(), 1u);
    EXPECT_EQ(must(store->treatment_marks(patient.id))[0].text, "SECRETMARK");
    EXPECT_EQ(must(store->clinical_scores(patient.id)).at(0).text, "SECRETSCORE");
    EXPECT_EQ(must(store->primary_measures(patient.id)).at(0).chosen_by, "SECRETCHOOSER");
    const StablePeriod period = must(store->stable_periods(patient.id)).at(0);
    EXPECT_EQ(period.judged_by + period.text, "SECRETJUDGESECRETPERIOD");
    const SessionRecord session = must(store->sessions(patient.id)).at(0);
    EXPECT_EQ(must(store->events(session.id)).at(0).text, "SECRETEVENT");
    EXPECT_EQ(must(store->events(session.id)).at(1).text, "key");
    EXPECT_EQ(must(store->signals(must(store->trials(session.id)).at(0))).rows(), 100u);
    EXPECT_EQ(must(consents(*done.access, patient.code)).at(0).text, "SECRETFORM");
  }
  must(set_identity(*done.access, "P-1", {"Vera", "", ""}));
  EXPECT_EQ(must(read_identity(*done.access, "P-1"))->name, "Vera");
}

TEST_F(PlainClinic, ProtectedLaterOpensForItsPassphraseAndRecoveryKeyOnly) {
  auto done = must(protect());
  must(accept_recovery_key(*done.access, done.recovery_key));
  done.access.reset();
  EXPECT_FALSE(open_store(path, OpenMode::read_only).ok());
  const auto access = must(Access::open(path));
  EXPECT_NE(refusal(access->log_in_with_passphrase(secret("another passphrase"))), "");
  must(access->log_in_with_recovery_key(done.recovery_key));
  access->log_out();
  must(access->log_in_with_passphrase(secret("the clinic's passphrase")));
  must(add_user(*access, "Theo", Role::therapist, secret("theo's password"), kCheapKeyCost));
}

TEST_F(PlainClinic, ProtectedLaterLeavesASoundCopyAndNamesIt) {
  must(opened(path)->backup(folder.file("monday.db")));
  const auto done = must(protect());
  EXPECT_EQ(done.copy, path + ".before-protection");
  ASSERT_EQ(done.remains.size(), 2u);
  EXPECT_NE(done.remains[0].find("monday.db"), std::string::npos);
  EXPECT_NE(done.remains[1].find("clinic.db.before-protection"), std::string::npos);
  EXPECT_FALSE(is_protected_database(done.copy));
  const auto store = opened(done.copy, OpenMode::read_only);
  EXPECT_TRUE(must(store->check()).empty());
  EXPECT_EQ(must(store->profile(1)).notes, "SECRETNOTE");
}

/// The log of the time without a key is chained to the entry that the key proves.
TEST_F(PlainClinic, ProtectedLaterProvesTheLogOfBefore) {
  const auto done = must(protect());
  const auto problems = [&] { return must(check_audit(*done.access)); };
  EXPECT_EQ(problems(), std::vector<Text>{});
  const auto entries = must(read_audit(*done.access));
  EXPECT_EQ(must(read_audit(*done.access, {"protect", "clinic.db"})).size(), 1u);
  soci::session sql(soci::sqlite3, "db=\"" + path + "\"");
  sql << "DROP TRIGGER audit_log_is_not_changed";
  // Somebody without a key changes an entry and computes the hashes of before anew.
  std::string id;
  sql << "SELECT database_id FROM access_settings", soci::into(id);
  std::string before = first_hash(nullptr, id);
  for (AuditEntry entry : entries) {
    if (entry.act == kProtectAct) break;
    std::string chain;
    sql << "SELECT coalesce(lower(hex(chain)), '') FROM row_seals WHERE id = :id",
        soci::use(entry.seals), soci::into(chain);
    if (entry.number == 1) entry.detail = "changed";
    entry.hash = entry_hash(nullptr, before, entry, chain);
    before = entry.hash;
    sql << "UPDATE audit_log SET detail = :detail, hash = :hash WHERE id = :id",
        soci::use(entry.detail), soci::use(entry.hash), soci::use(entry.number);
  }
  ASSERT_EQ(problems().size(), 1u);
  EXPECT_NE(english(problems()[0]).find("was changed"), std::string::npos);
}

TEST_F(PlainClinic, IsNotProtectedWhileAnotherProgramHasItOpen) {
  {
    const auto other = opened(path);
    EXPECT_NE(refusal(protect()).find("another program"), std::string::npos);
    must(other->add_patient("P-3"));
  }
  EXPECT_FALSE(is_protected_database(path));
  EXPECT_NE(refusal(protect("seven77")).find("passphrase"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(path + ".before-protection")) << "nothing half made";
  EXPECT_TRUE(must(opened(path)->check()).empty());
  const auto done = must(protect());
  EXPECT_EQ(must(opened(path)->patients()).size(), 3u);
}

TEST_F(PlainClinic, ProtectedTwiceIsOnlyRewritten) {
  const auto first = must(protect());
  must(accept_recovery_key(*first.access, first.recovery_key));
  EXPECT_NE(refusal(protect("another passphrase")), "");
  const auto again = must(protect());
  EXPECT_TRUE(again.recovery_key.empty());
  EXPECT_TRUE(again.copy.empty());
  EXPECT_FALSE(again.not_swept);
  EXPECT_EQ(must(opened(path)->profile(1)).notes, "SECRETNOTE");
  EXPECT_FALSE(std::filesystem::exists(path + ".before-protection-2"));
}

TEST_F(PlainClinic, IsNotMergedWithAProtectedOneWhicheverWayRound) {
  const std::string other = folder.file("other.db");
  const auto made = must(Access::create(other, secret("the clinic's passphrase"), &kCheapKeyCost));
  for (const auto& [into, from] : {std::pair{path, other}, {other, path}})
    EXPECT_NE(refusal(merge_databases(into, from)).find("cannot be merged"), std::string::npos);
  made.access->log_out();
  EXPECT_NE(refusal(merge_databases(path, other)).find("cannot be merged"), std::string::npos);
}

}  // namespace
}  // namespace isograsp::storage::protection_test
